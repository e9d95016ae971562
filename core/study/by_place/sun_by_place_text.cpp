#include <fmt/format.h>

#include "core/base/version.h"
#include "core/describe/figure_text.h"
#include "core/describe/text.h"
#include "core/receivers/place_names.h"
#include "core/study/by_place/sun_by_place.h"
#include "core/study/provenance/provenance_json.h"
#include "core/study/text/error_json.h"
#include "core/study/text/period_json.h"
#include "core/study/text/warnings_json.h"

namespace noonmark {

namespace {

using Json = nlohmann::ordered_json;

constexpr int digits = 4;  // of hours and shares

Figure hours(double SunOfPlace::*member, std::string_view key, std::string_view label,
             std::string_view definition) {
    return figure(member, {.key = key,
                           .label = label,
                           .definition = definition,
                           .decimals = 3,
                           .jsonDecimals = digits,
                           .shownDecimals = 2});
}

std::string monthKey(const std::string& month) { return "hours_" + month; }
std::string dateKey(const CivilDate& date) { return "share_below_" + formatText(date); }

LonLat middleOf(const Place& place, const Frame& frame) {
    const Box2 box = bounds(place);
    return frame.lonLatFromLocal((glm::dvec2(box.low) + glm::dvec2(box.high)) * 0.5);
}

std::vector<ElementColumn> columnsOf(const SunByPlace& sun) {
    std::vector<ElementColumn> columns{{"name", std::string()}, {"kind", std::string()}};
    for (const Figure& figure : sunOfPlaceFigures().rows())
        columns.push_back({std::string(figure.key), 0.0, figure.decimals});
    for (const std::string& month : sun.months) columns.push_back({monthKey(month), 0.0, digits});
    for (const CivilDate& date : sun.settings.dates) columns.push_back({dateKey(date), 0.0, digits});
    columns.push_back({"lon_deg", 0.0, placeDecimals});
    columns.push_back({"lat_deg", 0.0, placeDecimals});
    columns.push_back({"source", std::string()});
    return columns;
}

std::vector<ElementValue> rowOf(const SunByPlace& sun, std::size_t i) {
    const Place& place = sun.places[i];
    std::vector<ElementValue> row{place.name, std::string(nameOf(place.kind))};
    const DescribedFigures figures = sunOfPlaceFigures().of(sun.sun[i]);
    for (const Figure& figure : figures.figures) row.emplace_back(figures.get(figure));
    for (const double hours : sun.sun[i].monthHours) row.emplace_back(hours);
    for (const double share : sun.sun[i].belowShare) row.emplace_back(share);
    const LonLat middle = middleOf(place, sun.city.frame);
    row.insert(row.end(), {middle.lonDeg, middle.latDeg, place.source});
    return row;
}

Json placeJson(const SunByPlace& sun, std::size_t i) {
    const Place& place = sun.places[i];
    const SunOfPlace& of = sun.sun[i];
    Json json{{"name", place.name}, {"kind", nameOf(place.kind)}};
    json.update(figuresJson(sunOfPlaceFigures().of(of)));
    for (std::size_t month = 0; month < of.monthHours.size(); ++month)
        json["month_hours"][sun.months[month]] = of.monthHours[month];
    for (std::size_t date = 0; date < of.belowShare.size(); ++date)
        json["share_below"][formatText(sun.settings.dates[date])] = of.belowShare[date];
    json["source"] = place.source;
    return json;
}

}  // namespace

const Figures<SunOfPlace>& sunOfPlaceFigures() {
    static const Figures<SunOfPlace> figures{
        figure(&SunOfPlace::areaM2, {.key = "area_m2",
                                     .label = NM_TEXT("Open ground"),
                                     .definition = NM_TEXT("area of the place without buildings"),
                                     .jsonDecimals = 2,
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
             .unit = FigureUnit::share}),
    };
    return figures;
}

ElementTable makeTable(const SunByPlace& sun) {
    ElementTable table{.columns = columnsOf(sun), .rows = {}, .places = {}};
    for (std::size_t i = 0; i < sun.places.size(); ++i) table.rows.push_back(rowOf(sun, i));
    return table;
}

std::string toJson(const SunByPlace& sun) {
    const StudySettings& study = sun.settings.study;
    Json json{{"program", std::string("Noonmark ") + std::string(version())},
              {"period", periodJson(study.period, sun.daylight, makeObserver(sun.city, study))},
              {"cell_m", study.receivers.cellM},
              {"enough_hours", sun.settings.enoughHours},
              {"possible_hours", sun.possibleHours},
              {"engine", sun.field.engine}};
    json["steps"] = sun.daylight.steps.size();
    json["steps_below_horizon"] = sun.daylight.belowHorizon;
    json["error"] = sun.error ? errorJson(*sun.error, sun.city.frame) : Json();
    json["seconds"] = sun.seconds;
    json["places"] = Json::array();
    for (std::size_t i = 0; i < sun.places.size(); ++i) json["places"].push_back(placeJson(sun, i));
    json["definitions"] = definitionsJson(sunOfPlaceFigures().rows());
    json["warnings"] = warningsJson(sun.warnings);
    addProvenance(json, sun.provenance);
    return toJsonText(json);
}

}  // namespace noonmark
