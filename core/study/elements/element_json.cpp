#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/base/version.h"
#include "core/city/building_heights.h"
#include "core/describe/figure_text.h"
#include "core/study/elements/element_fields.h"
#include "core/study/elements/element_study.h"
#include "core/study/elements/element_tables.h"
#include "core/study/provenance/provenance_texts.h"
#include "core/study/provenance/repeat_command.h"
#include "core/study/study_json.h"
#include "core/study/text/error_text.h"
#include "core/study/text/height_facts_text.h"
#include "core/study/text/region_text.h"
#include "core/study/text/terrain_text.h"

namespace noonmark {

namespace {

using ElementJson = nlohmann::ordered_json;

// A file without its folder, as other inputs are named.
std::string parcelName(const ElementSettings& elements) {
    std::error_code ignored;
    const std::filesystem::path parcel(elements.parcel);
    return std::filesystem::is_regular_file(parcel, ignored) ? parcel.filename().string() : elements.parcel;
}

void addPlaneJson(ElementJson& json, const ElementStudy& study) {
    json["plane_above_ground_m"] = study.elements.planeHeightM;
    json["plane_elevation_m"] = study.planeM + study.city.frame.originElevationM();
}

void addFaceJson(ElementJson& json, const ElementSettings& elements) {
    const FaceChoice& faces = elements.faces;
    if (!faces.faces.empty()) json["faces"] = faces.faces;
    if (faces.facing) json["facing_deg"] = {faces.facing->fromDeg, faces.facing->toDeg};
    if (faces.place.empty()) return;
    json["facing_place"] = faces.place;
    json["within_m"] = faces.withinM;
}

ElementJson listJson(const std::vector<ListedPoint>& points) {
    ElementJson list = ElementJson::array();
    for (const ListedPoint& point : points) {
        ElementJson one{{"id", point.id}, {"lon_deg", point.at.lonDeg}, {"lat_deg", point.at.latDeg}};
        if (point.heightM) one["above_ground_m"] = *point.heightM;
        if (point.facingDeg) one["facing_deg"] = *point.facingDeg;
        list.push_back(std::move(one));
    }
    return list;
}

ElementJson whereJson(const ElementStudy& study) {
    const ElementSettings& elements = study.elements;
    ElementJson json;
    json["receivers_on"] = nameOf(elements.places);
    if (elements.places == ElementPlaces::facades) {
        json["buildings"] = elements.proposed            ? ElementJson("proposed")
                            : elements.buildings.empty() ? ElementJson("all of the region")
                                                         : ElementJson(elements.buildings);
        json["bay_m"] = elements.facades.bayM;
        json["storey_m"] = elements.facades.storeyM;
        json["above_floor_m"] = elements.facades.aboveFloorM;
    }
    addFaceJson(json, elements);
    if (elements.places == ElementPlaces::windows && study.glazingInput)
        json["windows"] = inputsJson({*study.glazingInput});
    if (elements.places == ElementPlaces::plane) {
        json["cell_m"] = study.settings.receivers.cellM;
        addPlaneJson(json, study);
    }
    if (elements.places == ElementPlaces::lines) {
        json["parcel"] = parcelName(elements);
        json["offsets_m"] = elements.lines.offsetsM;
        json["spacing_m"] = elements.lines.spacingM;
        addPlaneJson(json, study);
    }
    if (elements.places == ElementPlaces::points) json["points"] = listJson(elements.points);
    return json;
}

void addTreesJson(ElementJson& json, const ElementStudy& study) {
    for (const ShadedElementFigures& with : listFiguresWithTrees(study))
        json.update(figuresJson({elementFiguresWithTrees(with.column), &with.figures}));
    if (!study.city.trees) return;
    json["trees"] = treesJson(*study.city.trees);
    json["trees"]["used"] = study.trees ? study.trees->treesUsed : 0;
    if (!study.trees) return;
    json["trees"]["shaded_from"] = study.trees->shadedFrom;
    json["trees"]["how"] = study.trees->how;
}

ElementJson elementErrorJson(const ElementStudy& study) {
    if (!study.error) return {};
    const ElementError& error = *study.error;
    const auto json = [](const QuantityError& of) {
        return ElementJson{{"mean_pct", of.meanPct}, {"p99_pct", of.p99Pct}, {"max_pct", of.largestPct}};
    };
    return {{"points", error.points},
            {"rays", error.rays},
            {"gross", json(error.gross)},
            {"continuous", json(error.continuous)},
            {"longest_sun", error.longestSun ? json(*error.longestSun) : ElementJson()}};
}

std::string_view definitionOf(std::string_view key) {
    return findFigure(pointFigures().rows(), key).definition;
}

ElementJson elementDefinitions() {
    return {
        {"sunlit", definitionOf("sunlit_min")},
        {"gross", definitionOf("gross_min")},
        {"continuous", definitionOf("continuous_min")},
        {"longest_sun", definitionOf("longest_sun_min")},
        {"error",
         "of the engine against the ray reference on a sample of points and all steps: absolute differences, "
         "for gross in percent of the period's time with the sun up, for continuous and longest_sun of the "
         "longest day's; p99_pct: 99 % of the points differ by no more"},
        {"facades",
         "one point in the middle of each bay of each storey of a wall; none where another part "
         "touches the wall or the ground covers it"},
        {"windows", "one point in the middle of each window"},
        {"plane",
         "one point in the middle of each cell, on a level plane above the mean of the region's "
         "ground"},
        {"lines",
         "points at equal distances on lines around the parcel, at the height of a level plane above the "
         "mean of its ground, facing up"},
        {"points", "the listed points, on the ground or roof where no height is given"},
        {"facing_place",
         "points from which a level line straight out from the wall meets the place within within_m"},
        {"azimuth", "that the surface faces, from true north, clockwise"},
        {"floor", "storeys of storey_m from the lowest point of the building, unless the windows state it"}};
}

}  // namespace

std::vector<CommandOption> listElementOptions(const ElementSettings& elements) {
    ElementSettings named = elements;
    named.windows = elements.windows.filename();
    named.parcel = parcelName(elements);
    named.pointsFile = elements.pointsFile.filename();
    std::vector<CommandOption> options = listOptions(elementFields().of(named));
    for (const auto* fields : {&facadesOfFields(), &pointFields()})
        std::ranges::move(listOptions(fields->of(named)), std::back_inserter(options));
    return options;
}

namespace {

void addElementCost(ElementJson& json, const ElementStudy& study,
                    const std::map<std::string, double>& writeSeconds) {
    json["rays"] = study.minutes.cost.rays;
    json["seconds"] = study.seconds;
    json["accumulate_seconds"] = study.minutes.cost.seconds;
    if (!writeSeconds.empty()) json["write_seconds"] = writeSeconds;
}

}  // namespace

Result<std::string> makeRepeatCommand(const ElementStudy& study, std::size_t width) {
    RepeatQuestion question{"study", study.settings, study.provenance, study.engineKey};
    if (question.provenance.region.empty())
        question.provenance.region = formatRegion(study.settings.region, study.city);
    // Points have neither months nor contributions, and are receivers of their own.
    question.settings.byMonth = question.settings.contributions = false;
    question.settings.receivers.places = ReceiverPlaces::ground;
    question.options = listElementOptions(study.elements);
    return makeRepeatCommand(question, width);
}

std::string elementStudyJson(const ElementStudy& study, const std::map<std::string, double>& writeSeconds) {
    ElementJson json;
    json["program"] = std::string("Noonmark ") + std::string(version());
    json["engine"] = study.settings.engine;
    json["engine_used"] = study.engineKey;
    json["engine_settings"] = describeEngine(study);
    const Observer observer = makeObserver(study.city, study.settings);
    json["period"] = periodJson(study.settings.period, study.sun, observer);
    json["steps"] = study.sun.steps.size();
    json["steps_below_horizon"] = study.sun.belowHorizon;
    json.update(figuresJson(elementFigures().of(computeFigures(study))));
    addTreesJson(json, study);
    json["error"] = elementErrorJson(study);
    json["buildings"] = study.city.buildings.size();
    addElementCost(json, study, writeSeconds);
    json["elements"] = whereJson(study);
    json["region"] = regionJson(study.settings.region, study.city.frame);
    json["terrain"] = study.city.terrain ? terrainJson(*study.city.terrain) : ElementJson();
    json["observer"] = observerJson(observer);
    json["sun_frame"] = sunFrameJson(study.city, study.settings, study.sun);
    addProvenance(json, study.provenance);
    json["heights"] = heightsJson(countHeights(study.city), study.heights);
    addRepeat(json, makeRepeatCommand(study));
    json["definitions"] = elementDefinitions();
    json["definitions"].update(definitionsJson(elementFigures().rows()));
    for (const ShadedElementFigures& with : listFiguresWithTrees(study))
        json["definitions"].update(definitionsJson(elementFiguresWithTrees(with.column)));
    json["warnings"] = warningsJson(study.warnings);
    return toJsonText(json);
}

}  // namespace noonmark
