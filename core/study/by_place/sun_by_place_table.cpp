#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <functional>

#include "core/describe/figure_text.h"
#include "core/describe/text.h"
#include "core/receivers/place_names.h"
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
        columns.partChanges(baseline.withTrees[column].sun, with.sun, trees + city);
    }
}

void addWhere(PlaceColumns& columns, const SunByPlace& sun) {
    columns.number("cell_m", minuteDecimals, [&sun](std::size_t i) {
        return sun.sun[i].cellM > 0 ? sun.sun[i].cellM : SunOfPlace::none;
    });
    columns.text("without_figures",
                 [&sun](std::size_t i) { return textOrNone(std::string(describe(sun.sun[i].status))); });
    columns.text("remarks", [&sun](std::size_t i) { return textOrNone(remarksOf(sun.sun[i])); });
    columns.number("lon_deg", placeDecimals,
                   [&sun](std::size_t i) { return middleOf(sun.places[i], sun.city.frame).lonDeg; });
    columns.number("lat_deg", placeDecimals,
                   [&sun](std::size_t i) { return middleOf(sun.places[i], sun.city.frame).latDeg; });
    columns.text("source", [&sun](std::size_t i) { return ElementValue(sun.places[i].source); });
}

}  // namespace

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
    columns.text("part_of", [&](std::size_t i) {
        return textOrNone(sun.partOf[i] ? sun.places[*sun.partOf[i]].name : std::string());
    });
    addCity(columns, sun, {});
    const std::vector<std::string> suffixes = suffixesOf(compared);
    for (std::size_t i = 0; i < compared.size(); ++i) addCompared(columns, sun, compared[i], suffixes[i]);
    addWhere(columns, sun);
    return columns.table();
}

}  // namespace noonmark
