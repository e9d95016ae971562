#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <limits>

#include "core/base/json_number.h"
#include "core/base/version.h"
#include "core/describe/figure_text.h"
#include "core/describe/text.h"
#include "core/measures/shadow_figures.h"
#include "core/receivers/place_names.h"
#include "core/study/by_place/sun_by_place.h"
#include "core/study/provenance/provenance_texts.h"
#include "core/study/study_json.h"
#include "core/study/text/error_text.h"

namespace noonmark {

namespace {

using Json = nlohmann::ordered_json;

// As JSON and CSV state them, which agree to the last digit.
constexpr int digits = 4;     // of hours and shares
constexpr int fewDigits = 2;  // of areas and minutes

Figure hours(double SunOfPlace::*member, std::string_view key, std::string_view label,
             std::string_view definition) {
    return figure(member, {.key = key,
                           .label = label,
                           .definition = definition,
                           .decimals = digits,
                           .jsonDecimals = digits,
                           .shownDecimals = 2,
                           .better = Better::higher});
}

std::string dateHoursKey(const CivilDate& date) { return hoursColumn(formatText(date)); }
std::string dateKey(const CivilDate& date) { return "share_below_" + formatText(date); }

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

// The area is the same in all cities.
bool isCompared(const Figure& figure) { return figure.use != FigureUse::basis; }

void addDateColumns(std::vector<ElementColumn>& columns, const SunByPlace& sun, const std::string& suffix) {
    for (const CivilDate& date : sun.settings.dates)
        columns.push_back({dateHoursKey(date) + suffix, 0.0, digits});
    for (const CivilDate& date : sun.settings.dates) columns.push_back({dateKey(date) + suffix, 0.0, digits});
}

void addChangeColumns(std::vector<ElementColumn>& columns, std::span<const Figure> figures,
                      const std::string& suffix) {
    for (const Figure& figure : figures)
        columns.push_back({std::string(figure.key) + suffix, 0.0, figure.decimals});
}

void addComparedColumns(std::vector<ElementColumn>& columns, std::span<const ComparedSun> compared) {
    const std::vector<std::string> suffixes = suffixesOf(compared);
    for (std::size_t i = 0; i < compared.size(); ++i) {
        const SunByPlace& sun = compared[i].sun;
        for (const Figure& figure : sunOfPlaceFigures().rows())
            if (isCompared(figure))
                columns.push_back({std::string(figure.key) + suffixes[i], 0.0, figure.decimals});
        addDateColumns(columns, sun, suffixes[i]);
        addChangeColumns(columns, sunChangeFigures().rows(), suffixes[i]);
        for (const SunWithTrees& with : sun.withTrees) {
            addChangeColumns(columns, sunFiguresWithTrees(with.column), suffixes[i]);
            addDateColumns(columns, sun, suffixOf(with.column) + suffixes[i]);
            addChangeColumns(columns, changeFiguresWithTrees(with.column), suffixes[i]);
        }
    }
}

// Of seasons, months and dates of the city measured first.
void addPartColumns(std::vector<ElementColumn>& columns, const SunByPlace& sun, const std::string& suffix) {
    for (const SunSeason& season : sun.seasons)
        columns.push_back({hoursColumn(season.key) + suffix, 0.0, digits});
    for (const std::string& month : sun.months) columns.push_back({hoursColumn(month) + suffix, 0.0, digits});
    addDateColumns(columns, sun, suffix);
}

// Nothing where a place has no cell.
void addValues(std::vector<ElementValue>& row, const std::vector<double>& values, std::size_t columns) {
    for (std::size_t i = 0; i < columns; ++i)
        row.emplace_back(i < values.size() ? values[i] : SunOfPlace::none);
}

// Empty: the place stands for itself.
std::string wholeOf(const SunByPlace& sun, std::size_t i) {
    return sun.partOf[i] ? sun.places[*sun.partOf[i]].name : std::string();
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

void addFigures(std::vector<ElementValue>& row, const DescribedFigures& of) {
    for (const Figure& figure : of.figures) row.emplace_back(of.get(figure));
}

void addDateValues(std::vector<ElementValue>& row, const SunByPlace& sun, const SunOfPlace& of) {
    addValues(row, of.dateHours, sun.settings.dates.size());
    addValues(row, of.belowShare, sun.settings.dates.size());
}

void addComparedValues(std::vector<ElementValue>& row, const ComparedSun& compared, std::size_t i) {
    const DescribedFigures sun = sunOfPlaceFigures().of(compared.sun.sun[i]);
    for (const Figure& figure : sun.figures)
        if (isCompared(figure)) row.emplace_back(sun.get(figure));
    addDateValues(row, compared.sun, compared.sun.sun[i]);
    addFigures(row, sunChangeFigures().of(compared.changes[i]));
    for (std::size_t column = 0; column < compared.sun.withTrees.size(); ++column) {
        const SunWithTrees& with = compared.sun.withTrees[column];
        addFigures(row, {sunFiguresWithTrees(with.column), &with.sun[i]});
        addDateValues(row, compared.sun, with.sun[i]);
        addFigures(row, {changeFiguresWithTrees(with.column), &compared.changesWithTrees[column][i]});
    }
}

void addPartValues(std::vector<ElementValue>& row, const SunByPlace& sun, const SunOfPlace& of) {
    addValues(row, of.seasonHours, sun.seasons.size());
    addValues(row, of.monthHours, sun.months.size());
    addDateValues(row, sun, of);
}

std::vector<ElementColumn> columnsOf(const SunByPlace& sun, std::span<const ComparedSun> compared) {
    std::vector<ElementColumn> columns{
        {"name", std::string()}, {"kind", std::string()}, {"part_of", std::string()}};
    for (const Figure& figure : sunOfPlaceFigures().rows())
        columns.push_back({std::string(figure.key), 0.0, figure.decimals});
    addPartColumns(columns, sun, {});
    for (const SunWithTrees& with : sun.withTrees) {
        addChangeColumns(columns, sunFiguresWithTrees(with.column), {});
        addPartColumns(columns, sun, suffixOf(with.column));
    }
    addComparedColumns(columns, compared);
    columns.push_back({"cell_m", 0.0, 2});
    columns.push_back({"without_figures", std::string()});
    columns.push_back({"remarks", std::string()});
    columns.push_back({"lon_deg", 0.0, placeDecimals});
    columns.push_back({"lat_deg", 0.0, placeDecimals});
    columns.push_back({"source", std::string()});
    return columns;
}

std::vector<ElementValue> rowOf(const SunByPlace& sun, std::span<const ComparedSun> compared, std::size_t i) {
    const Place& place = sun.places[i];
    const SunOfPlace& of = sun.sun[i];
    std::vector<ElementValue> row{place.name, std::string(nameOf(place.kind)), textOrNone(wholeOf(sun, i))};
    addFigures(row, sunOfPlaceFigures().of(of));
    addPartValues(row, sun, of);
    for (const SunWithTrees& with : sun.withTrees) {
        addFigures(row, {sunFiguresWithTrees(with.column), &with.sun[i]});
        addPartValues(row, sun, with.sun[i]);
    }
    for (const ComparedSun& one : compared) addComparedValues(row, one, i);
    const LonLat middle = middleOf(place, sun.city.frame);
    row.insert(row.end(),
               {of.cellM > 0 ? of.cellM : SunOfPlace::none, textOrNone(std::string(describe(of.why))),
                textOrNone(remarksOf(of)), middle.lonDeg, middle.latDeg, place.source});
    return row;
}

void addParts(Json& json, const SunByPlace& sun, const SunOfPlace& of, const std::string& suffix) {
    for (std::size_t season = 0; season < of.seasonHours.size(); ++season)
        json["season_hours" + suffix][sun.seasons[season].key] = roundAsText(of.seasonHours[season], digits);
    for (std::size_t month = 0; month < of.monthHours.size(); ++month)
        json["month_hours" + suffix][sun.months[month]] = roundAsText(of.monthHours[month], digits);
    for (std::size_t date = 0; date < of.dateHours.size(); ++date)
        json["date_hours" + suffix][formatText(sun.settings.dates[date])] =
            roundAsText(of.dateHours[date], digits);
    for (std::size_t date = 0; date < of.belowShare.size(); ++date)
        json["share_below" + suffix][formatText(sun.settings.dates[date])] =
            roundAsText(of.belowShare[date], digits);
}

Json figuresOf(const SunByPlace& sun, std::size_t i) {
    Json json = figuresJson(sunOfPlaceFigures().of(sun.sun[i]));
    addParts(json, sun, sun.sun[i], {});
    for (const SunWithTrees& with : sun.withTrees) {
        json.update(figuresJson({sunFiguresWithTrees(with.column), &with.sun[i]}));
        addParts(json, sun, with.sun[i], suffixOf(with.column));
    }
    return json;
}

Json placeJson(const SunByPlace& sun, std::span<const ComparedSun> compared, std::size_t i) {
    const Place& place = sun.places[i];
    Json json{{"name", place.name}, {"kind", nameOf(place.kind)}};
    if (sun.partOf[i]) json["part_of"] = wholeOf(sun, i);
    json.update(figuresOf(sun, i));
    json["cell_m"] = sun.sun[i].cellM > 0 ? Json(sun.sun[i].cellM) : Json();
    if (sun.sun[i].why != NoSunFigures::measured)
        json["without_figures"] = keyOf(noSunChoices(), sun.sun[i].why);
    for (const PlaceRemark remark : sun.sun[i].remarks)
        json["remarks"].push_back(keyOf(placeRemarkChoices(), remark));
    for (const ComparedSun& one : compared) {
        Json other = figuresOf(one.sun, i);
        other.update(figuresJson(sunChangeFigures().of(one.changes[i])));
        for (std::size_t column = 0; column < one.sun.withTrees.size(); ++column)
            other.update(figuresJson({changeFiguresWithTrees(one.sun.withTrees[column].column),
                                      &one.changesWithTrees[column][i]}));
        json["scenarios"][one.sun.name] = std::move(other);
    }
    json["source"] = place.source;
    return json;
}

// What the changes refer to, and the error of each compared city.
void addComparison(Json& json, const SunByPlace& sun, std::span<const ComparedSun> compared) {
    json["baseline"] = sun.name;
    json["loss_min"] = sun.settings.lossMin;
    for (const ComparedSun& one : compared)
        json["scenarios"].push_back(
            {{"name", one.sun.name},
             {"engine", one.sun.field.engine},
             {"error", one.sun.error ? errorJson(*one.sun.error, sun.city.frame) : Json()},
             {"errors", errorsJson(one.sun.errors)},
             {"seconds", one.sun.seconds},
             {"warnings", warningsJson(one.sun.warnings)}});
    json["definitions"].update(definitionsJson(sunChangeFigures().rows()));
    for (const SunWithTrees& with : sun.withTrees)
        json["definitions"].update(definitionsJson(changeFiguresWithTrees(with.column)));
}

constexpr std::array noSunList{
    Choice<NoSunFigures>{NoSunFigures::builtOver, "built_over", NM_TEXT("buildings stand on all of it")},
    Choice<NoSunFigures>{NoSunFigures::betweenCells, "between_cells",
                         NM_TEXT("no cell has its centre on its open ground")},
};

constexpr std::array placeRemarkList{
    Choice<PlaceRemark>{PlaceRemark::beyondTerrain, "beyond_terrain",
                        NM_TEXT("beyond the terrain: the nearest elevation is taken")},
    Choice<PlaceRemark>{PlaceRemark::onWater, "on_water",
                        NM_TEXT("mostly on water: measured at its surface")},
};

}  // namespace

std::string hoursColumn(std::string_view of) { return fmt::format("hours_{}", of); }

std::span<const Choice<PlaceRemark>> placeRemarkChoices() { return placeRemarkList; }

std::vector<std::string_view> listRemarks(const SunOfPlace& of) {
    std::vector<std::string_view> words;
    if (of.why != NoSunFigures::measured) words.push_back(describe(of.why));
    for (const Choice<PlaceRemark>& choice : placeRemarkList)
        if (std::ranges::find(of.remarks, choice.value) != of.remarks.end()) words.push_back(choice.label);
    return words;
}

std::span<const Choice<NoSunFigures>> noSunChoices() { return noSunList; }

std::string_view describe(NoSunFigures why) {
    for (const Choice<NoSunFigures>& choice : noSunList)
        if (choice.value == why) return choice.label;
    return {};
}

const Figures<SunOfPlace>& sunOfPlaceFigures() {
    static const Figures<SunOfPlace> figures{
        figure(&SunOfPlace::areaM2, {.key = "area_m2",
                                     .label = NM_TEXT("Open ground"),
                                     .definition = NM_TEXT("area of the place without buildings"),
                                     .decimals = fewDigits,
                                     .jsonDecimals = fewDigits,
                                     .unit = FigureUnit::squareMetres,
                                     .use = FigureUse::basis}),
        hours(&SunOfPlace::meanHours, "hours_mean", NM_TEXT("Mean sun"),
              NM_TEXT("hours of sun a day, mean over the days and the place")),
        hours(&SunOfPlace::minHours, "hours_min", NM_TEXT("Min sun"),
              NM_TEXT("hours of sun a day, mean over the days, at the cell that has least")),
        hours(&SunOfPlace::maxHours, "hours_max", NM_TEXT("Max sun"),
              NM_TEXT("hours of sun a day, mean over the days, at the cell that has most")),
        figure(
            &SunOfPlace::enoughShare,
            {.key = "share_enough",
             .label = NM_TEXT("Share with enough sun"),
             .definition = NM_TEXT("share of the area with the hours of sun a day that are enough, or more"),
             .decimals = digits,
             .jsonDecimals = digits,
             .unit = FigureUnit::share,
             .better = Better::higher}),
    };
    return figures;
}

const Figures<SunChange>& sunChangeFigures() {
    static const Figures<SunChange> figures{
        figure(&SunChange::meanHours,
               {.key = "change_hours",
                .label = NM_TEXT("Change of mean sun"),
                .definition = NM_TEXT("hours of sun a day more than in the baseline, mean over the days and "
                                      "the place; negative: less"),
                .decimals = digits,
                .jsonDecimals = digits,
                .shownDecimals = 2,
                .better = Better::higher,
                .isChange = true}),
        figure(
            &SunChange::maxLossMin,
            {.key = "max_loss_min",
             .label = NM_TEXT("Largest loss"),
             .definition = NM_TEXT("minutes of sun a day less than in the baseline, mean over the days, at "
                                   "the cell that loses most"),
             .decimals = fewDigits,
             .jsonDecimals = fewDigits,
             .unit = FigureUnit::minutesADay,
             .better = Better::lower}),
        figure(
            &SunChange::maxGainMin,
            {.key = "max_gain_min",
             .label = NM_TEXT("Largest gain"),
             .definition = NM_TEXT("minutes of sun a day more than in the baseline, mean over the days, at "
                                   "the cell that gains most"),
             .decimals = fewDigits,
             .jsonDecimals = fewDigits,
             .unit = FigureUnit::minutesADay,
             .better = Better::higher}),
        figure(&SunChange::lostShare,
               {.key = "share_lost",
                .label = NM_TEXT("Share that loses sun"),
                .definition = NM_TEXT("share of the area that loses more minutes of sun a day than the "
                                      "threshold of loss"),
                .decimals = digits,
                .jsonDecimals = digits,
                .unit = FigureUnit::share}),
    };
    return figures;
}

std::span<const Figure> sunFiguresWithTrees(TreeColumns column) {
    static const FiguresWithTrees evergreen(sunOfPlaceFigures().rows(), TreeColumns::evergreen);
    static const FiguresWithTrees seasonal(sunOfPlaceFigures().rows(), TreeColumns::seasonal);
    return (column == TreeColumns::evergreen ? evergreen : seasonal).rows();
}

std::span<const Figure> changeFiguresWithTrees(TreeColumns column) {
    static const FiguresWithTrees evergreen(sunChangeFigures().rows(), TreeColumns::evergreen);
    static const FiguresWithTrees seasonal(sunChangeFigures().rows(), TreeColumns::seasonal);
    return (column == TreeColumns::evergreen ? evergreen : seasonal).rows();
}

ElementTable makeTable(const SunByPlace& sun, std::span<const ComparedSun> compared) {
    ElementTable table{.columns = columnsOf(sun, compared), .rows = {}, .places = {}};
    for (std::size_t i = 0; i < sun.places.size(); ++i) table.rows.push_back(rowOf(sun, compared, i));
    return table;
}

std::string describeCellError(const std::optional<SampledError>& error) {
    if (!error) return "not measured";
    const CellError& gross = error->gross;
    return fmt::format("{:.3f} % mean, {:.2f} % largest, against rays", gross.percent(gross.meanMin),
                       gross.percent(gross.maxMin));
}

std::string toJson(const SunByPlace& sun, std::span<const ComparedSun> compared) {
    const StudySettings& study = sun.settings.study;
    Json json{{"program", std::string("Noonmark ") + std::string(version())},
              {"period", periodJson(study.period, sun.daylight, makeObserver(sun.city, study))},
              {"cell_m", study.receivers.cellM},
              {"small_cell_m", sun.settings.smallCellM},
              {"enough_hours", sun.settings.enoughHours},
              {"possible_hours", sun.possibleHours},
              {"engine", sun.field.engine}};
    if (!sun.withTrees.empty()) json["engine_trees"] = sun.treesHow;
    json["steps"] = sun.daylight.steps.size();
    json["steps_below_horizon"] = sun.daylight.belowHorizon;
    json["error"] = sun.error ? errorJson(*sun.error, sun.city.frame) : Json();
    for (std::size_t date = 0; date < sun.dateErrors.size(); ++date)
        json["date_errors"][formatText(sun.settings.dates[date])] =
            sun.dateErrors[date] ? errorJson(*sun.dateErrors[date], sun.city.frame) : Json();
    json["errors"] = errorsJson(sun.errors);
    for (const SunSeason& season : sun.seasons) json["seasons"][season.key] = season.label;
    json["seconds"] = sun.seconds;
    json["places"] = Json::array();
    for (std::size_t i = 0; i < sun.places.size(); ++i) json["places"].push_back(placeJson(sun, compared, i));
    json["definitions"] = definitionsJson(sunOfPlaceFigures().rows());
    for (const SunWithTrees& with : sun.withTrees)
        json["definitions"].update(definitionsJson(sunFiguresWithTrees(with.column)));
    if (!compared.empty()) addComparison(json, sun, compared);
    json["warnings"] = warningsJson(sun.warnings);
    addProvenance(json, sun.provenance);
    addRepeat(json, makeRepeatCommand(sun, compared, std::numeric_limits<std::size_t>::max()));
    return toJsonText(json);
}

}  // namespace noonmark
