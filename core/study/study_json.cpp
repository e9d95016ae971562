#include "core/study/study_json.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "core/base/version.h"
#include "core/city/meshes/surface_mesher.h"
#include "core/city/terrain/building_ground.h"
#include "core/describe/field_json.h"
#include "core/describe/figure_text.h"
#include "core/engines/api/shadow_field.h"
#include "core/measures/shadow_figures.h"
#include "core/receivers/roof_receivers.h"
#include "core/simd/instruction_set.h"
#include "core/study/provenance/provenance_texts.h"
#include "core/study/provenance/repeat_command.h"
#include "core/study/text/breakdown_text.h"
#include "core/study/text/error_text.h"
#include "core/study/text/height_facts_text.h"
#include "core/study/text/terrain_text.h"
#include "core/sun/period_fields.h"
#include "core/sun/sun_paths.h"
#include "core/sun/zone_country.h"

namespace noonmark {

using Json = nlohmann::ordered_json;

namespace {

Json cellsJson(const Study& study) {
    const Grid& grid = study.receivers.grid;
    const auto count = [&](const char* reason) {
        const auto found = study.field.cost.skipped.find(reason);
        return found == study.field.cost.skipped.end() ? 0 : found->second;
    };
    return {{"cell_m", grid.cellM},
            {"receivers_on", nameOf(study.settings.receivers.places)},
            {"columns", grid.columns},
            {"rows", grid.rows},
            {"west_m", grid.westM},
            {"south_m", grid.southM},
            {"outside_region", count(cellsOutside)},
            {"under_buildings", count(cellsUnderBuildings)},
            {"on_water", count(cellsOnWater)},
            {"crs", study.city.frame.projString()},
            {"row_order", "row 0 is the southernmost; in shadow.tif the northernmost"}};
}

// Buildings are used or skipped; each engine states in words what else it skipped.
void addCost(Json& json, const Study& study, const FileSeconds& writeSeconds) {
    const Cost& cost = study.field.cost;
    const std::size_t buildings = study.city.buildings.size();
    json["buildings"] = buildings;
    json["buildings_used"] = cost.buildingsUsed;
    json["buildings_skipped"] = {
        {"shadow cannot reach a receiver", buildings - std::min<std::size_t>(buildings, cost.buildingsUsed)}};
    json["skipped"] = cost.skipped;
    json["rays"] = cost.rays;
    const auto trace = study.seconds.find("accumulate");
    const bool timed = trace != study.seconds.end() && trace->second > 0 && cost.rays > 0;
    json["mega_rays_per_s"] = timed ? Json(double(cost.rays) * 1e-6 / trace->second) : Json();
    json["seconds"] = study.seconds;
    json["accumulate_seconds"] = cost.seconds;
    if (!writeSeconds.empty()) json["write_seconds"] = writeSeconds;
}

Json definitions(bool runs) {
    const std::string continuous = "longest unbroken run in shadow on any day of the period, minutes";
    return {
        {"gross", "minutes per day that a receiver is in shadow, averaged over the days of the period"},
        {"continuous", runs ? continuous : continuous + "; null: it was not counted"},
        {"fraction_of_time",
         "share of the period's time with the sun above the horizon; steps with the sun below it are left "
         "out"},
        {"error",
         "of the engine against the ray reference on a sample of receivers and all steps: area_pct, its "
         "shadow area minus the reference's, divided by the sample's area; gross and continuous, the "
         "absolute differences of the cells, as shares of whole_min (the sunlit minutes of a mean day, of "
         "the longest day)"},
        {"errors",
         "of each quantity shown, against the ray reference on a sample: the mean of the absolute "
         "differences, what 99 of 100 of them do not exceed, and the largest"},
        {"receiver",
         "a cell of the region with its centre at the place that receivers_on states: on the ground, outside "
         "every footprint that stands on it and off the water of the map, or on the roof of a building "
         "there, its highest surface"},
        {"period",
         "the hours of each day (hours_min_per_day in the mean) are divided into whole steps of nearly "
         "step_min; each counts counted_step_min, so that no time is dropped; the steps of a day add up to "
         "its hours within day_rounding_min"},
        {"azimuth", "from true north, clockwise"},
        {"sun_frame",
         "the sun is the observer's, rotated into the frame of the geometry: north_turned_deg, clockwise, "
         "from the frame's +y to the observer's north; vertical_turned_deg, for the drop of the terrain; "
         "vertical_error_deg, the error of the vertical at the farthest corner of the region (1 deg = 4 "
         "minutes of the sun's motion); steps_levelled, steps with the sun below the frame's horizontal "
         "plane, moved into that plane"}};
}

}  // namespace

std::string studyJson(const Study& study, const FileSeconds& writeSeconds) {
    Json json;
    json["program"] = std::string("Noonmark ") + std::string(version());
    json["instruction_set"] = nameOf(instructionSetInUse());
    json["engine"] = study.settings.engine;
    json["engine_used"] = study.field.engineKey;
    json["engine_options"] = study.settings.engineSettings;
    json["engine_settings"] = study.field.engine;
    json["period"] = periodJson(study.settings.period, study.sun, makeObserver(study));
    json["steps"] = study.sun.steps.size();
    json["steps_below_horizon"] = study.sun.belowHorizon;
    json["sunlit_min_per_day"] = study.field.sunlitMinutesPerDay;
    json.update(figuresJson(shadowFigures().of(study.statistics)));
    for (const ShadeColumn& shade : listShadeColumns(study.field)) {
        const ShadowStatistics statistics = computeStatistics(*shade.field);
        json.update(figuresJson({treeFigures(shade.column), &statistics}));
    }
    if (study.city.trees) json["trees"] = treesJson(*study.city.trees, study.field);
    json["error"] = errorJson(study);
    json["errors"] = errorsJson(listErrors(study));
    addCost(json, study, writeSeconds);
    if (study.settings.byMonth)
        json["by_month"] =
            monthsJson(study.breakdown ? monthsOf(*study.breakdown) : std::vector<MonthShadow>(),
                       listMonthsWithTrees(study));
    json["region"] = regionJson(study.settings.region, study.city.frame);
    json["cells"] = cellsJson(study);
    json["terrain"] = study.city.terrain ? terrainJson(*study.city.terrain) : Json();
    if (study.city.terrain) json["beyond_terrain"] = makeCoverageJson(study.terrainCoverage);
    json["observer"] = observerJson(makeObserver(study));
    json["sun_frame"] = sunFrameJson(study.city, study.settings, study.sun);
    addProvenance(json, study.provenance);
    json["heights"] = heightsJson(countHeights(study.city), study.heights);
    addRepeat(json, makeRepeatCommand(study, std::numeric_limits<std::size_t>::max()));
    json["definitions"] = definitions(hasRuns(study.statistics));
    json["definitions"].update(definitionsJson(shadowFigures().rows()));
    for (const ShadeColumn& shade : listShadeColumns(study.field))
        json["definitions"].update(definitionsJson(treeFigures(shade.column)));
    json["warnings"] = warningsJson(study.warnings);
    return toJsonText(json);
}

std::string studyJson(const Study& study) { return studyJson(study, {}); }

namespace {

// CityCounts from one pass over the city.
struct CityCounts {
    std::size_t parts = 0;
    std::size_t overhanging = 0;
    std::size_t triangles = 0;
    float tallestM = 0;
    std::string tallest;
};

void add(CityCounts& counts, const Part& part) {
    ++counts.parts;
    if (part.isOverhanging) ++counts.overhanging;
    counts.triangles += countTriangles(part);
}

CityCounts countsOf(const City& city) {
    CityCounts counts;
    for (const auto& building : city.buildings) {
        for (const Part& part : building->parts) add(counts, part);
        const float height = heightM(*building, city);
        if (height <= counts.tallestM) continue;
        counts.tallestM = height;
        counts.tallest = building->name.empty() ? building->sourceId : building->name;
    }
    return counts;
}

// The lowest and the highest of some values; null without any.
class Range {
public:
    void add(double value) {
        low_ = std::min(low_, value);
        high_ = std::max(high_, value);
    }
    [[nodiscard]] Json json() const { return low_ > high_ ? Json() : Json{low_, high_}; }

private:
    double low_ = std::numeric_limits<double>::max();
    double high_ = std::numeric_limits<double>::lowest();
};

// Heights of parts, metres, by their source; sources that no part has are left out.
Json heightRanges(const City& city) {
    std::array<Range, heightSources.size()> ranges;
    for (const auto& building : city.buildings)
        for (const Part& part : building->parts)
            ranges[std::size_t(part.heightSource)].add(double(part.topM) - double(part.bottomM));
    Json json = Json::object();
    for (const HeightSource source : heightSources)
        if (Json range = ranges[std::size_t(source)].json(); !range.is_null())
            json[std::string(nameOf(source))] = std::move(range);
    return json;
}

// Elevations of the ground that buildings stand on, metres above the datum of the city.
Json groundRange(const City& city) {
    Range range;
    for (const auto& building : city.buildings)
        range.add(city.frame.originElevationM() + double(findGroundUnder(*building, city)));
    return range.json();
}

// Elevations of the terrain's posts, metres above the datum of the city.
Json terrainRange(const City& city) {
    if (!city.terrain) return nullptr;
    const PostGrid& posts = city.terrain->grid;
    Range range;
    for (int row = 0; row < posts.rows; ++row)
        for (int column = 0; column < posts.columns; ++column)
            range.add(city.frame.originElevationM() + earthDropM(posts.centre(column, row)) +
                      double(city.terrain->elevationM[posts.index(column, row)]));
    return range.json();
}

// Of the buildings; of a terrain alone its own.
Box2 coveredBox(const City& city) {
    const Box2 box = bounds(city);
    return box.empty() && city.terrain ? bounds(city.terrain->grid) : box;
}

Json extentLonLat(const City& city) {
    const Box2 box = coveredBox(city);
    if (box.empty()) return nullptr;
    const LonLat low = city.frame.lonLatFromLocal(glm::dvec2(box.low));
    const LonLat high = city.frame.lonLatFromLocal(glm::dvec2(box.high));
    return {low.lonDeg, low.latDeg, high.lonDeg, high.latDeg};
}

// The town nearest to the middle of it; null without a table of towns.
Json townJson(const City& city) {
    const Box2 box = coveredBox(city);
    if (box.empty()) return nullptr;
    const auto middle = (glm::dvec2(box.low) + glm::dvec2(box.high)) / 2.0;
    const auto town = findNearestTown(city.frame.lonLatFromLocal(middle));
    if (!town) return nullptr;
    return {{"name", town->name},
            {"country", countryName(town->country)},
            {"away_m", std::round(town->distanceM)}};
}

}  // namespace

std::string infoJson(const CityRead& read) {
    const CityCounts counts = countsOf(read.city);
    Json info;
    info["format"] = read.format;
    info["features"] = read.features;
    info["buildings"] = read.city.buildings.size();
    info["parts"] = counts.parts;
    info["parts_hanging"] = counts.overhanging;
    info["triangles"] = counts.triangles;
    info["heights"] = heightsJson(countHeights(read.city), read.heights);
    info["height_sources"] = info["heights"]["by_source"];
    info["height_ranges_m"] = heightRanges(read.city);
    info["ground_m"] = groundRange(read.city);
    info["terrain_m"] = terrainRange(read.city);
    info["tallest_m"] = double(counts.tallestM);
    info["tallest"] = counts.tallest;
    info["crs"] = read.crs;
    info["nearest_town"] = townJson(read.city);
    info["extent_lonlat"] = extentLonLat(read.city);
    info["origin_lonlat"] = {read.city.frame.origin().lonDeg, read.city.frame.origin().latDeg};
    info["origin_elevation_m"] = read.city.frame.originElevationM();
    info["terrain"] = read.city.terrain != nullptr;
    info["terrain_source"] = read.city.terrain ? terrainJson(*read.city.terrain) : Json();
    info["trees"] = read.city.trees ? treesJson(*read.city.trees) : Json();
    info["attribution"] = read.attribution;
    info["changes"] = changesJson(read.warnings);
    info["warnings"] = warningsJson(read.warnings);
    return toJsonText(info);
}

namespace {

// Its fields; null where one does not apply. The sunrise rule is stated by the altitude in `window`.
nlohmann::ordered_json askedJson(const Period& period) {
    const Described asked = periodFields().of(period);
    const auto applying = fieldsJson(asked);
    nlohmann::ordered_json json;
    for (const Field& field : asked.fields) {
        const std::string key(field.key);
        if (field.needs.empty()) json[key] = applying.value(key, nlohmann::ordered_json());
    }
    return json;
}

}  // namespace

nlohmann::ordered_json periodJson(const Period& period, const SunSteps& sun, const Observer& observer) {
    nlohmann::ordered_json json{{"text", formatText(period)}};
    json.update(askedJson(period));
    json["counted_step_min"] = sun.stepMinutes;
    json["hours_min_per_day"] = sun.days.empty() ? 0 : sun.countedMinutes / double(sun.days.size());
    json["day_rounding_min"] = sun.maxOffADayMin;
    if (period.window)
        json["window"] = {{"after_sunrise_min", period.window->afterSunrise.count()},
                          {"before_sunset_min", period.window->beforeSunset.count()},
                          {"sunrise_altitude_deg",
                           computeSunriseAltitudeDeg(period.window->rule, relativeAirDensity(observer))}};
    json["days_without_sun"] = std::ranges::count(sun.days, 0U, &SunDay::count);
    return json;
}

nlohmann::ordered_json observerJson(const Observer& observer) {
    return {{"lon_deg", observer.place.lonDeg},
            {"lat_deg", observer.place.latDeg},
            {"elevation_m", observer.elevationM},
            {"pressure_hpa", observer.pressureHPa},
            {"temperature_c", observer.temperatureC}};
}

nlohmann::ordered_json sunFrameJson(const City& city, const StudySettings& settings, const SunSteps& sun) {
    const SunFrameFacts facts = computeSunFrame(city, settings);
    return {{"north_turned_deg", facts.convergenceDeg},
            {"vertical_turned_deg", facts.tiltDeg},
            {"farthest_from_observer_m", facts.farthestM},
            {"vertical_error_deg", facts.verticalErrorDeg},
            {"steps_levelled", sun.levelled}};
}

nlohmann::ordered_json regionJson(const Region& region, const Frame& frame) {
    const Box2 box = bounds(region);
    const LonLat low = frame.lonLatFromLocal(glm::dvec2(box.low));
    const LonLat high = frame.lonLatFromLocal(glm::dvec2(box.high));
    return {{"name", region.name},
            {"polygons", region.polygons.size()},
            {"area_m2", area(region)},
            {"extent_lonlat", {low.lonDeg, low.latDeg, high.lonDeg, high.latDeg}}};
}

}  // namespace noonmark
