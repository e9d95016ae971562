#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <limits>

#include "core/base/json_number.h"
#include "core/base/version.h"
#include "core/base/wording.h"
#include "core/describe/field_json.h"
#include "core/describe/figure_text.h"
#include "core/describe/fill_text.h"
#include "core/describe/text.h"
#include "core/measures/shadow_figures.h"
#include "core/receivers/place_names.h"
#include "core/study/by_place/place_tables.h"
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

// Empty: the place stands for itself.
std::string wholeOf(const SunByPlace& sun, std::size_t i) {
    return sun.partOf[i] ? sun.places[*sun.partOf[i]].name : std::string();
}

// Of the city measured first, whose days are those of all.
struct Stated {
    const SunByPlace& sun;
    std::vector<SunPart> parts = listParts(sun);
};

// Of a part of the period: in all of them, by the part's key.
std::string keyOf(SunPart::Of of, std::string_view what) { return fmt::format("{}_{}", nameOf(of), what); }

double hoursIn(const std::vector<double>& parts, std::size_t i) {
    return i < parts.size() ? parts[i] : SunOfPlace::none;
}

// Hours as they are, minutes of shadow where the days of the part are known.
void addParts(Json& json, const Stated& stated, const SunOfPlace& of, const std::string& suffix) {
    for (const SunPart& part : stated.parts) {
        const std::vector<double>& hours = of.*part.hours;
        if (part.index >= hours.size()) continue;
        json[keyOf(part.of, "hours") + suffix][part.key] = roundAsText(hours[part.index], digits);
        if (!std::isnan(part.possibleHours))
            json[keyOf(part.of, "shadow_min") + suffix][part.key] =
                roundAsText(shadowMinOf(hours[part.index], part.possibleHours), fewDigits);
    }
    for (std::size_t date = 0; date < of.belowShare.size(); ++date)
        json["share_below" + suffix][formatText(stated.sun.settings.dates[date])] =
            roundAsText(of.belowShare[date], digits);
}

void addShadow(Json& json, const Stated& stated, const SunOfPlace& of, const std::string& suffix) {
    const double possibleHours = stated.sun.possibleHours;
    if (std::isnan(possibleHours)) return;
    for (const ShadowFigure& figure : shadowOfPlaceFigures())
        json[figure.key + suffix] = roundAsText(shadowMinOf(of.*figure.hours, possibleHours), fewDigits);
}

void addChanges(Json& json, std::span<const Figure> figures, const SunChange& change,
                const std::string& suffix) {
    json.update(figuresJson({figures, &change}));
    json["change_shadow_min" + suffix] = roundAsText(-minutesPerHour * change.meanHours, fewDigits);
}

// What changes by season, month and date.
void addPartChanges(Json& json, const Stated& stated, const SunOfPlace& before, const SunOfPlace& after,
                    const std::string& suffix) {
    for (const SunPart& part : stated.parts)
        if (part.index < (after.*part.hours).size())
            json[keyOf(part.of, "change_hours") + suffix][part.key] = roundAsText(
                hoursIn(after.*part.hours, part.index) - hoursIn(before.*part.hours, part.index), digits);
}

Json figuresOf(const Stated& stated, const SunByPlace& sun, std::size_t i) {
    Json json = figuresJson(sunOfPlaceFigures().of(sun.sun[i]));
    addShadow(json, stated, sun.sun[i], {});
    addParts(json, stated, sun.sun[i], {});
    for (const SunWithTrees& with : sun.withTrees) {
        json.update(figuresJson({sunFiguresWithTrees(with.column), &with.sun[i]}));
        addShadow(json, stated, with.sun[i], suffixOf(with.column));
        addParts(json, stated, with.sun[i], suffixOf(with.column));
    }
    return json;
}

Json placeJson(const Stated& stated, std::span<const ComparedSun> compared, std::size_t i) {
    const SunByPlace& sun = stated.sun;
    const Place& place = sun.places[i];
    Json json{{"name", place.name}, {"kind", nameOf(place.kind)}};
    if (sun.partOf[i]) json["part_of"] = wholeOf(sun, i);
    json.update(figuresOf(stated, sun, i));
    json["cell_m"] = sun.sun[i].cellM > 0 ? Json(sun.sun[i].cellM) : Json();
    if (sun.sun[i].status != PlaceStatus::measured)
        json["without_figures"] = keyOf(placeStatusChoices(), sun.sun[i].status);
    for (const PlaceRemark remark : sun.sun[i].remarks)
        json["remarks"].push_back(keyOf(placeRemarkChoices(), remark));
    for (const ComparedSun& one : compared) {
        Json other = figuresOf(stated, one.sun, i);
        addChanges(other, sunChangeFigures().rows(), one.changes[i], {});
        addPartChanges(other, stated, sun.sun[i], one.sun.sun[i], {});
        for (std::size_t column = 0; column < one.sun.withTrees.size(); ++column) {
            const SunWithTrees& with = one.sun.withTrees[column];
            const std::string trees = suffixOf(with.column);
            addChanges(other, changeFiguresWithTrees(with.column), one.changesWithTrees[column][i], trees);
            addPartChanges(other, stated, sunInColumn(sun, with.column)[i], with.sun[i], trees);
        }
        json["scenarios"][one.sun.name] = std::move(other);
    }
    json["source"] = place.source;
    return json;
}

void defineShadow(Json& definitions) {
    for (const ShadowFigure& figure : shadowOfPlaceFigures()) definitions[figure.key] = figure.definition;
    for (const char* part : {"season", "month", "date"})
        definitions[fmt::format("{}_shadow_min", part)] =
            fmt::format("minutes of shadow a day: the sunlit time of the {} less {}_hours", part, part);
}

// What the changes refer to, and the error of each compared city.
void addComparison(Json& json, const SunByPlace& sun, std::span<const ComparedSun> compared) {
    json["baseline"] = sun.name;
    for (const ComparedSun& one : compared)
        json["scenarios"].push_back(
            {{"name", one.sun.name},
             {"engine", one.sun.field.engine},
             {"error", one.sun.error ? errorJson(*one.sun.error, sun.city.frame) : Json()},
             {"errors", errorsJson(one.sun.errors)},
             {"seconds", one.sun.seconds},
             {"warnings", warningsJson(one.sun.warnings)}});
    json["definitions"].update(definitionsJson(sunChangeFigures().rows()));
    json["definitions"]["change_shadow_min"] =
        "minutes of shadow a day more than in the baseline, mean over the days and the place; negative: less";
    for (const ComparedSun& one : compared)
        for (const SunWithTrees& with : one.sun.withTrees)
            json["definitions"].update(definitionsJson(changeFiguresWithTrees(with.column)));
}

// The dates stand in the figures of each place, and a loss counts against a baseline only.
Json settingsJson(const SunByPlaceSettings& settings, bool isCompared) {
    Json json = fieldsJson(sunByPlaceFields().of(settings));
    json.erase("dates");
    if (!isCompared) json.erase("loss_min");
    return json;
}

constexpr std::array placeStatusList{
    Choice<PlaceStatus>{PlaceStatus::builtOver, "built_over", NM_TEXT("buildings stand on all of it")},
    Choice<PlaceStatus>{PlaceStatus::betweenCells, "between_cells",
                        NM_TEXT("no cell has its centre on its open ground")},
};

constexpr std::array placeRemarkList{
    Choice<PlaceRemark>{PlaceRemark::beyondTerrain, "beyond_terrain",
                        NM_TEXT("beyond the terrain: the nearest elevation is taken")},
    Choice<PlaceRemark>{PlaceRemark::onWater, "on_water",
                        NM_TEXT("mostly on water: measured at its surface")},
};

}  // namespace

std::span<const Choice<PlaceRemark>> placeRemarkChoices() { return placeRemarkList; }

std::vector<std::string_view> listRemarks(const SunOfPlace& of) {
    std::vector<std::string_view> words;
    if (of.status != PlaceStatus::measured) words.push_back(describe(of.status));
    for (const Choice<PlaceRemark>& choice : placeRemarkList)
        if (std::ranges::find(of.remarks, choice.value) != of.remarks.end()) words.push_back(choice.label);
    return words;
}

std::span<const Choice<PlaceStatus>> placeStatusChoices() { return placeStatusList; }

std::string_view describe(PlaceStatus status) {
    for (const Choice<PlaceStatus>& choice : placeStatusList)
        if (choice.value == status) return choice.label;
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

std::string describeCellError(const std::optional<SampledError>& error) {
    if (!error) return localText(NM_TEXT("not measured"));
    const CellError& gross = error->gross;
    return fillText(NM_TEXT("%1 % mean, %2 % largest, against rays"),
                    {localNumbers(fmt::format("{:.3f}", gross.percent(gross.meanMin))),
                     localNumbers(fmt::format("{:.2f}", gross.percent(gross.maxMin)))});
}

std::string toJson(const SunByPlace& sun, std::span<const ComparedSun> compared) {
    const StudySettings& study = sun.settings.study;
    Json json{{"program", std::string("Noonmark ") + std::string(version())},
              {"period", periodJson(study.period, sun.daylight, makeObserver(sun.city, study))},
              {"cell_m", study.receivers.cellM}};
    json.update(settingsJson(sun.settings, !compared.empty()));
    json["possible_hours"] = sun.possibleHours;
    json["engine"] = sun.field.engine;
    if (listSunColumns(sun, compared).size() > 1) json["engine_trees"] = sun.treesHow;
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
    const Stated stated{sun};
    for (std::size_t i = 0; i < sun.places.size(); ++i)
        json["places"].push_back(placeJson(stated, compared, i));
    json["definitions"] = definitionsJson(sunOfPlaceFigures().rows());
    defineShadow(json["definitions"]);
    for (const TreeColumns column : listSunColumns(sun, compared))
        if (column != TreeColumns::without)
            json["definitions"].update(definitionsJson(sunFiguresWithTrees(column)));
    if (!compared.empty()) addComparison(json, sun, compared);
    json["warnings"] = warningsJson(sun.warnings);
    addProvenance(json, sun.provenance);
    addRepeat(json, makeRepeatCommand(sun, compared, std::numeric_limits<std::size_t>::max()));
    return toJsonText(json);
}

}  // namespace noonmark
