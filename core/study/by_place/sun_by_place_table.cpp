#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <functional>

#include "core/describe/figure_text.h"
#include "core/describe/text.h"
#include "core/receivers/place_names.h"
#include "core/study/by_place/place_tables.h"
#include "core/study/by_place/sum_places.h"
#include "core/study/by_place/sun_by_place.h"

namespace noonmark {

namespace {

constexpr int hourDecimals = 4;
constexpr int minuteDecimals = 2;

LonLat middleOf(const Place& place, const Frame& frame) {
    const Box2 box = bounds(place);
    return frame.lonLatFromLocal((glm::dvec2(box.low) + glm::dvec2(box.high)) * 0.5);
}

// The name of a city at the end of a column: "tower_b" for "Tower B".
std::string suffixOf(const std::string& name) {
    std::string suffix = "_";
    for (const char c : name) {
        const bool isPlain = (c & 0x80) != 0 || std::isalnum(static_cast<unsigned char>(c)) != 0;
        if (isPlain)
            suffix += char((c & 0x80) != 0 ? c : std::tolower(static_cast<unsigned char>(c)));
        else if (suffix.back() != '_')
            suffix += '_';
    }
    if (suffix.size() > 1 && suffix.back() == '_') suffix.pop_back();
    return suffix;
}

// Each different: names that differ by case or signs alone get a number.
std::vector<std::string> suffixesOf(std::span<const ComparedSun> compared) {
    std::vector<std::string> suffixes;
    for (const ComparedSun& one : compared) {
        const std::string plain = suffixOf(one.sun.name);
        std::string own = plain;
        for (int number = 2; std::ranges::find(suffixes, own) != suffixes.end(); ++number)
            own = fmt::format("{}_{}", plain, number);
        suffixes.push_back(own);
    }
    return suffixes;
}

ElementValue textOrNone(const std::string& text) {
    return text.empty() ? ElementValue() : ElementValue(text);
}

std::string remarksOf(const SunOfPlace& of) {
    std::string words;
    for (const Choice<PlaceRemark>& choice : placeRemarkChoices())
        if (std::ranges::find(of.remarks, choice.value) != of.remarks.end())
            words += (words.empty() ? "" : "; ") + std::string(choice.label);
    return words;
}

// Nothing where a place has no cell.
double valueAt(const std::vector<double>& values, std::size_t i) {
    return i < values.size() ? values[i] : SunOfPlace::none;
}

/// A column and what it states of each place, by the place's index.
struct PlaceColumn {
    ElementColumn column;
    std::function<ElementValue(std::size_t)> of;
};

using OfPlaces = std::vector<SunOfPlace>;

ElementValue namedWhole(const SunByPlace& sun, std::size_t place) {
    return textOrNone(sun.partOf[place] ? sun.places[*sun.partOf[place]].name : std::string());
}

double cellOf(const SunOfPlace& of) { return of.cellM > 0 ? of.cellM : SunOfPlace::none; }

/// The columns in their order. What they refer to must outlive them.
class PlaceColumns {
public:
    explicit PlaceColumns(const SunByPlace& sun) : sun_(sun), parts_(listParts(sun)) {}

    void text(std::string name, std::function<ElementValue(std::size_t)> of) {
        columns_.push_back({{std::move(name), std::string()}, std::move(of)});
    }
    void number(std::string name, int decimals, std::function<double(std::size_t)> of) {
        columns_.push_back({{std::move(name), 0.0, decimals}, std::move(of)});
    }

    /// What one city, or one column with trees, gets: hours and shares, then the same as minutes of shadow.
    /// The area is the same in all cities and stated once.
    void city(std::span<const Figure> figures, const OfPlaces& of, const std::string& trees,
              const std::string& city) {
        for (const Figure& figure : figures)
            if (city.empty() || figure.use != FigureUse::basis)
                number(std::string(figure.key) + city, figure.decimals,
                       [&figure, &of](std::size_t i) { return figure.get(&of[i]); });
        parts(of, trees + city);
        shadow(of, trees + city);
    }

    /// What it changes against the baseline.
    void changes(std::span<const Figure> figures, const std::vector<SunChange>& of, const std::string& trees,
                 const std::string& city) {
        for (const Figure& figure : figures)
            number(std::string(figure.key) + city, figure.decimals,
                   [&figure, &of](std::size_t i) { return figure.get(&of[i]); });
        number("change_shadow_min" + trees + city, minuteDecimals,
               [&of](std::size_t i) { return -minutesPerHour * of[i].meanHours; });
    }

    /// The same by season, month and date.
    void partChanges(const OfPlaces& before, const OfPlaces& after, const std::string& suffix) {
        for (const SunPart& part : parts_)
            number(changeColumn(part.key) + suffix, hourDecimals, [&before, &after, part](std::size_t i) {
                return valueAt(after[i].*part.hours, part.index) - valueAt(before[i].*part.hours, part.index);
            });
    }

    [[nodiscard]] ElementTable table() const {
        ElementTable table;
        for (const PlaceColumn& one : columns_) table.columns.push_back(one.column);
        for (std::size_t i = 0; i < sun_.places.size(); ++i) {
            auto& row = table.rows.emplace_back();
            for (const PlaceColumn& one : columns_) row.push_back(one.of(i));
        }
        return table;
    }

private:
    void parts(const OfPlaces& of, const std::string& suffix) {
        for (const SunPart& part : parts_)
            number(hoursColumn(part.key) + suffix, hourDecimals,
                   [&of, part](std::size_t i) { return valueAt(of[i].*part.hours, part.index); });
        for (std::size_t date = 0; date < sun_.settings.dates.size(); ++date)
            number("share_below_" + formatText(sun_.settings.dates[date]) + suffix, hourDecimals,
                   [&of, date](std::size_t i) { return valueAt(of[i].belowShare, date); });
    }

    // Nothing of parts whose days are not known: dates beyond the period, saved answers.
    void shadow(const OfPlaces& of, const std::string& suffix) {
        for (const ShadowFigure& figure : shadowOfPlaceFigures())
            minutes(figure.key + suffix, sun_.possibleHours,
                    [&of, figure](std::size_t i) { return of[i].*figure.hours; });
        for (const SunPart& part : parts_)
            minutes(shadowColumn(part.key) + suffix, part.possibleHours,
                    [&of, part](std::size_t i) { return valueAt(of[i].*part.hours, part.index); });
    }

    void minutes(std::string name, double possibleHours, std::function<double(std::size_t)> hours) {
        if (std::isnan(possibleHours)) return;
        number(std::move(name), minuteDecimals, [possibleHours, hours = std::move(hours)](std::size_t i) {
            return shadowMinOf(hours(i), possibleHours);
        });
    }

    const SunByPlace& sun_;
    std::vector<SunPart> parts_;
    std::vector<PlaceColumn> columns_;
};

void addCity(PlaceColumns& columns, const SunByPlace& sun, const std::string& city) {
    columns.city(sunOfPlaceFigures().rows(), sun.sun, {}, city);
    if (!city.empty()) return;
    for (const SunWithTrees& with : sun.withTrees)
        columns.city(sunFiguresWithTrees(with.column), with.sun, suffixOf(with.column), {});
}

void addCompared(PlaceColumns& columns, const SunByPlace& baseline, const ComparedSun& compared,
                 const std::string& city) {
    const SunByPlace& sun = compared.sun;
    columns.city(sunOfPlaceFigures().rows(), sun.sun, {}, city);
    columns.changes(sunChangeFigures().rows(), compared.changes, {}, city);
    columns.partChanges(baseline.sun, sun.sun, city);
    for (std::size_t column = 0; column < sun.withTrees.size(); ++column) {
        const SunWithTrees& with = sun.withTrees[column];
        const std::string trees = suffixOf(with.column);
        columns.city(sunFiguresWithTrees(with.column), with.sun, trees, city);
        columns.changes(changeFiguresWithTrees(with.column), compared.changesWithTrees[column], trees, city);
        columns.partChanges(sunInColumn(baseline, with.column), with.sun, trees + city);
    }
}

void addWhere(PlaceColumns& columns, const SunByPlace& sun) {
    columns.number("cell_m", minuteDecimals, [&sun](std::size_t i) { return cellOf(sun.sun[i]); });
    columns.text("without_figures",
                 [&sun](std::size_t i) { return textOrNone(std::string(describe(sun.sun[i].status))); });
    columns.text("remarks", [&sun](std::size_t i) { return textOrNone(remarksOf(sun.sun[i])); });
    columns.number("lon_deg", placeDecimals,
                   [&sun](std::size_t i) { return middleOf(sun.places[i], sun.city.frame).lonDeg; });
    columns.number("lat_deg", placeDecimals,
                   [&sun](std::size_t i) { return middleOf(sun.places[i], sun.city.frame).latDeg; });
    columns.text("source", [&sun](std::size_t i) { return ElementValue(sun.places[i].source); });
}

/// What the places get in one city with trees counted in one way, and how that differs from the baseline.
struct CitySun {
    const SunByPlace* city;
    TreeColumns trees;
    const OfPlaces* sun;
    const OfPlaces* before = nullptr;                 ///< null: it is the baseline
    const std::vector<SunChange>* changes = nullptr;  ///< null: it is the baseline
};

// The baseline first; in each city without trees first.
std::vector<CitySun> listSuns(const SunByPlace& baseline, std::span<const ComparedSun> compared) {
    std::vector<CitySun> suns{{&baseline, TreeColumns::without, &baseline.sun}};
    for (const SunWithTrees& with : baseline.withTrees) suns.push_back({&baseline, with.column, &with.sun});
    for (const ComparedSun& one : compared) {
        suns.push_back({&one.sun, TreeColumns::without, &one.sun.sun, &baseline.sun, &one.changes});
        for (std::size_t i = 0; i < one.sun.withTrees.size(); ++i) {
            const SunWithTrees& with = one.sun.withTrees[i];
            suns.push_back({&one.sun, with.column, &with.sun, &sunInColumn(baseline, with.column),
                            &one.changesWithTrees[i]});
        }
    }
    return suns;
}

/// What a row is about.
struct RowSubject {
    const SunByPlace& baseline;
    const CitySun& of;
    std::size_t place;
    const SunPart* part = nullptr;  ///< null: the whole period

    [[nodiscard]] const SunOfPlace& sun() const { return (*of.sun)[place]; }
    [[nodiscard]] const Place& where() const { return baseline.places[place]; }
    [[nodiscard]] double partHours() const { return valueAt(sun().*part->hours, part->index); }
    [[nodiscard]] double partChange() const {
        return of.before == nullptr ? SunOfPlace::none
                                    : partHours() - valueAt((*of.before)[place].*part->hours, part->index);
    }
};

/// A column of rows that may be about any city, trees and part of the period.
struct RowColumn {
    ElementColumn column;
    std::function<ElementValue(const RowSubject&)> of;
};
using RowColumns = std::vector<RowColumn>;

RowColumn textColumn(const char* name, std::function<ElementValue(const RowSubject&)> of) {
    return {{name, std::string()}, std::move(of)};
}

RowColumn numberColumn(std::string_view name, int decimals, std::function<double(const RowSubject&)> of) {
    return {{std::string(name), 0.0, decimals}, std::move(of)};
}

RowColumns columnsOfPlace() {
    return {textColumn("name", [](const RowSubject& row) { return row.where().name; }),
            textColumn("kind", [](const RowSubject& row) { return std::string(nameOf(row.where().kind)); }),
            textColumn("part_of", [](const RowSubject& row) { return namedWhole(row.baseline, row.place); }),
            textColumn("scenario", [](const RowSubject& row) { return textOrNone(row.of.city->name); }),
            textColumn("trees", [](const RowSubject& row) {
                return std::string(keyOf<TreeColumns>(treeColumnChoices, row.of.trees));
            })};
}

void addShadow(RowColumns& columns) {
    for (const ShadowFigure& figure : shadowOfPlaceFigures())
        columns.push_back(numberColumn(figure.key, minuteDecimals, [&figure](const RowSubject& row) {
            return shadowMinOf(row.sun().*figure.hours, row.baseline.possibleHours);
        }));
}

void addChanges(RowColumns& columns) {
    for (const Figure& figure : sunChangeFigures().rows())
        columns.push_back(numberColumn(figure.key, figure.decimals, [&figure](const RowSubject& row) {
            return row.of.changes == nullptr ? SunChange::none : figure.get(&(*row.of.changes)[row.place]);
        }));
    columns.push_back(numberColumn("change_shadow_min", minuteDecimals, [](const RowSubject& row) {
        return row.of.changes == nullptr ? SunChange::none
                                         : -minutesPerHour * (*row.of.changes)[row.place].meanHours;
    }));
}

void addWhere(RowColumns& columns) {
    const auto middle = [](const RowSubject& row) { return middleOf(row.where(), row.baseline.city.frame); };
    columns.push_back(
        numberColumn("cell_m", minuteDecimals, [](const RowSubject& row) { return cellOf(row.sun()); }));
    columns.push_back(textColumn("without_figures", [](const RowSubject& row) {
        return textOrNone(std::string(describe(row.sun().status)));
    }));
    columns.push_back(
        textColumn("remarks", [](const RowSubject& row) { return textOrNone(remarksOf(row.sun())); }));
    columns.push_back(numberColumn("lon_deg", placeDecimals,
                                   [middle](const RowSubject& row) { return middle(row).lonDeg; }));
    columns.push_back(numberColumn("lat_deg", placeDecimals,
                                   [middle](const RowSubject& row) { return middle(row).latDeg; }));
    columns.push_back(textColumn("source", [](const RowSubject& row) { return row.where().source; }));
}

ElementTable startTable(const RowColumns& columns) {
    ElementTable table;
    for (const RowColumn& one : columns) table.columns.push_back(one.column);
    return table;
}

void addRow(ElementTable& table, const RowColumns& columns, const RowSubject& subject) {
    auto& row = table.rows.emplace_back();
    for (const RowColumn& one : columns) row.push_back(one.of(subject));
}

ElementTable makePeriodTable(const SunByPlace& sun, std::span<const ComparedSun> compared) {
    RowColumns columns = columnsOfPlace();
    for (const Figure& figure : sunOfPlaceFigures().rows())
        columns.push_back(numberColumn(figure.key, figure.decimals,
                                       [&figure](const RowSubject& row) { return figure.get(&row.sun()); }));
    addShadow(columns);
    if (!compared.empty()) addChanges(columns);
    addWhere(columns);
    ElementTable table = startTable(columns);
    const std::vector<CitySun> suns = listSuns(sun, compared);
    for (std::size_t place = 0; place < sun.places.size(); ++place)
        for (const CitySun& of : suns) addRow(table, columns, {sun, of, place});
    return table;
}

RowColumns columnsOfParts(bool isCompared) {
    RowColumns columns = columnsOfPlace();
    columns.push_back(textColumn("time", [](const RowSubject& row) { return row.part->key; }));
    columns.push_back(
        textColumn("time_kind", [](const RowSubject& row) { return std::string(nameOf(row.part->of)); }));
    columns.push_back(
        numberColumn("hours_mean", hourDecimals, [](const RowSubject& row) { return row.partHours(); }));
    columns.push_back(numberColumn("shadow_mean_min", minuteDecimals, [](const RowSubject& row) {
        return shadowMinOf(row.partHours(), row.part->possibleHours);
    }));
    columns.push_back(numberColumn("share_below", hourDecimals, [](const RowSubject& row) {
        return row.part->of == SunPart::Of::date ? valueAt(row.sun().belowShare, row.part->index)
                                                 : SunOfPlace::none;
    }));
    if (isCompared)
        columns.push_back(numberColumn("change_hours", hourDecimals,
                                       [](const RowSubject& row) { return row.partChange(); }));
    return columns;
}

ElementTable makePartsTable(const SunByPlace& sun, std::span<const ComparedSun> compared) {
    const RowColumns columns = columnsOfParts(!compared.empty());
    ElementTable table = startTable(columns);
    const std::vector<SunPart> parts = listParts(sun);
    const std::vector<CitySun> suns = listSuns(sun, compared);
    for (std::size_t place = 0; place < sun.places.size(); ++place)
        for (const CitySun& of : suns)
            for (const SunPart& part : parts) addRow(table, columns, {sun, of, place, &part});
    return table;
}

}  // namespace

std::string_view nameOf(SunPart::Of of) {
    constexpr std::array<std::string_view, 3> names{"season", "month", "date"};
    return names[std::size_t(of)];
}

std::span<const PlaceTable> placeTables() {
    static constexpr std::array tables{PlaceTable{"places.csv", makePeriodTable},
                                       PlaceTable{"places_by_time.csv", makePartsTable}};
    return tables;
}

std::string hoursColumn(std::string_view of) { return fmt::format("hours_{}", of); }
std::string shadowColumn(std::string_view of) { return fmt::format("shadow_{}_min", of); }
std::string changeColumn(std::string_view of) { return fmt::format("change_hours_{}", of); }

double shadowMinOf(double sunHours, double possibleHours) {
    return minutesPerHour * (possibleHours - sunHours);
}

// Least sun is most shadow.
std::span<const ShadowFigure> shadowOfPlaceFigures() {
    static const std::array<ShadowFigure, 3> figures{{
        {&SunOfPlace::meanHours, "hours_mean", shadowColumn("mean"), NM_TEXT("Mean shadow"),
         NM_TEXT("minutes of shadow a day, mean over the days and the place")},
        {&SunOfPlace::minHours, "hours_min", shadowColumn("most"), NM_TEXT("Max shadow"),
         NM_TEXT("minutes of shadow a day, mean over the days, at the cell that has most")},
        {&SunOfPlace::maxHours, "hours_max", shadowColumn("least"), NM_TEXT("Min shadow"),
         NM_TEXT("minutes of shadow a day, mean over the days, at the cell that has least")},
    }};
    return figures;
}

const ShadowFigure* findShadow(const Figure& figure) {
    const std::array suffixes{std::string(), suffixOf(TreeColumns::evergreen),
                              suffixOf(TreeColumns::seasonal)};
    for (const ShadowFigure& shadow : shadowOfPlaceFigures())
        for (const std::string& suffix : suffixes)
            if (figure.key == std::string(shadow.sunKey) + suffix) return &shadow;
    return nullptr;
}

std::vector<SunPart> listParts(const SunByPlace& sun) {
    std::vector<SunPart> parts;
    const auto monthOf = [](const CivilDate& day) { return formatText(day).substr(0, 7); };
    for (std::size_t i = 0; i < sun.seasons.size(); ++i)
        parts.push_back(
            {sun.seasons[i].key, SunPart::Of::season, i, &SunOfPlace::seasonHours,
             possibleHoursOn(sun, [&](const CivilDate& day) { return isIn(sun.seasons[i], monthOf(day)); })});
    for (std::size_t i = 0; i < sun.months.size(); ++i)
        parts.push_back(
            {sun.months[i], SunPart::Of::month, i, &SunOfPlace::monthHours,
             possibleHoursOn(sun, [&](const CivilDate& day) { return monthOf(day) == sun.months[i]; })});
    for (std::size_t i = 0; i < sun.settings.dates.size(); ++i)
        parts.push_back(
            {formatText(sun.settings.dates[i]), SunPart::Of::date, i, &SunOfPlace::dateHours,
             possibleHoursOn(sun, [&](const CivilDate& day) { return day == sun.settings.dates[i]; })});
    return parts;
}

ElementTable makeTable(const SunByPlace& sun, std::span<const ComparedSun> compared) {
    PlaceColumns columns(sun);
    columns.text("name", [&](std::size_t i) { return ElementValue(sun.places[i].name); });
    columns.text("kind",
                 [&](std::size_t i) { return ElementValue(std::string(nameOf(sun.places[i].kind))); });
    columns.text("part_of", [&](std::size_t i) { return namedWhole(sun, i); });
    addCity(columns, sun, {});
    const std::vector<std::string> suffixes = suffixesOf(compared);
    for (std::size_t i = 0; i < compared.size(); ++i) addCompared(columns, sun, compared[i], suffixes[i]);
    addWhere(columns, sun);
    return columns.table();
}

}  // namespace noonmark
