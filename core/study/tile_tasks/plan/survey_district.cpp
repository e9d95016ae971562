#include "core/study/tile_tasks/plan/tile_load.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <iterator>
#include <set>
#include <span>
#include <unordered_set>

#include "core/describe/text.h"
#include "core/io/read_region.h"
#include "core/io/trees/read_trees.h"
#include "core/measures/places/place_run.h"
#include "core/measures/places/place_screening.h"
#include "core/receivers/place_names.h"

namespace noonmark {

namespace {

constexpr float blockM = 4000;
constexpr float borderM = 500;  // buildings at the edge of a block are read whole

Box2 grown(const Box2& box, float byM) { return {box.low - byM, box.high + byM}; }

Box2 localBox(const LonLatBox& box, const Frame& frame) {
    constexpr int pieces = 16;
    Box2 local;
    for (int i = 0; i <= pieces; ++i)
        for (int j = 0; j <= pieces; ++j)
            local.add(glm::vec2(
                frame.localFromLonLat({box.westDeg + (box.eastDeg - box.westDeg) * i / pieces,
                                       box.southDeg + (box.northDeg - box.southDeg) * j / pieces})));
    return grown(local, borderM);
}

LonLatBox boxOfCell(const FootprintScan::Cell& cell) {
    constexpr double side = FootprintScan::cellDeg;
    return {cell.first * side, cell.second * side, (cell.first + 1) * side, (cell.second + 1) * side};
}

double distanceBetween(const Box2& a, const Box2& b) {
    const glm::dvec2 apart = glm::max(glm::dvec2(0), glm::max(glm::dvec2(a.low) - glm::dvec2(b.high),
                                                              glm::dvec2(b.low) - glm::dvec2(a.high)));
    return glm::length(apart);
}

double reliefM(const City& ground) {
    if (!ground.terrain) return 0;
    const auto [low, high] = std::ranges::minmax(ground.terrain->elevationM);
    return double(high) - double(low);
}

// How far the shadow of an inventory's trees may reach, where no building stands near.
float reachOfTreesM(const ReadSettings& reading, const City& ground, const SunSteps& sun) {
    constexpr double tallestTreeM = 60;
    if (reading.treeFiles.empty()) return 0;
    return float(std::min((tallestTreeM + reliefM(ground)) * findLengthFactor(sun), reading.farAwayM));
}

// The region, and every coarse cell of the scan that holds something tall enough to reach it.
Box2 reachingBox(const Box2& region, const InputsScan& scan, const City& ground, const SunSteps& sun,
                 double farAwayM) {
    const double longest = findLengthFactor(sun), relief = reliefM(ground);
    Box2 box = region;
    for (const auto& [cell, tallest] : scan.footprints.tallestM) {
        const Box2 own = localBox(boxOfCell(cell), ground.frame);
        const glm::dvec2 middle = glm::dvec2(own.low + own.high) / 2.0;
        if (glm::length(middle) > farAwayM * 1.5) continue;
        if (distanceBetween(own, region) <= (tallest + relief) * longest) box.add(own);
    }
    return grown(box, borderM);
}

// Shadows of the dates of sun by place may reach farther than those of the period.
Result<void> addDates(SunSteps& sun, const ByPlaceRequest& request, Period day, const Observer& observer,
                      const std::stop_token& stop) {
    day.days = 1;
    for (const CivilDate& date : request.settings.dates) {
        day.start = date;
        const auto ofDay = computeSunSteps(day, observer, stop);
        if (!ofDay) return tl::make_unexpected(ofDay.error());
        sun.steps.insert(sun.steps.end(), ofDay->steps.begin(), ofDay->steps.end());
    }
    return {};
}

Result<SunSteps> sunOver(const City& ground, const TaskPlanRequest& request, const Region& region,
                         const std::stop_token& stop) {
    StudySettings settings = request.settings;
    settings.region = region;
    const Observer observer =
        request.timelines == nullptr ? makeObserver(ground, settings) : observerOfPlaces(ground);
    auto sun = computeDaylightSteps(settings.period, observer, stop);
    if (sun && request.byPlace != nullptr)
        if (auto added = addDates(*sun, *request.byPlace, settings.period, observer, stop); !added)
            return tl::make_unexpected(added.error());
    return sun;
}

Result<std::vector<Place>> placesOver(const Frame& frame, const TaskPlanRequest& request, Progress& progress,
                                      const std::stop_token& stop) {
    const TaskQuestion question = request.question();
    if (question.places() == nullptr) return std::vector<Place>{};
    return readPlaces(*question.places(), frame, progress, stop);
}

// Sun by place of a whole city is that of all places: their sun is that of their middle.
Result<void> takePlacesAsRegion(District& district, const std::vector<Place>& places,
                                const TaskPlanRequest& request) {
    if (places.empty())
        return failure("There is no place to measure", request.byPlace->places.string(),
                       "Choose other kinds of places, or another file");
    Box2 box;
    for (const Place& place : places) box.add(bounds(place));
    district.region = makeRegionFromLocalBox(box);
    district.region.name = "all places";
    return {};
}

// The region with all of each place that may belong to one of its tiles.
Box2 measuredBox(const Region& region, const std::vector<Place>& places) {
    const Box2 own = bounds(region);
    Box2 box = own;
    for (const Place& place : places) {
        const Box2 around = bounds(place);
        if (distanceBetween(around, own) <= 0) box.add(around);
    }
    return box;
}

bool anyBuilding(const FootprintScan& scan, const Frame& frame, const Box2& block) {
    const LonLatBox box = makeLonLatBox(frame, glm::dvec2(block.low), glm::dvec2(block.high));
    return std::ranges::any_of(scan.tallestM,
                               [&](const auto& cell) { return boxOfCell(cell.first).touches(box); });
}

// Files without a spatial index are read whole: once, and only if they touch the box.
Result<void> surveyWholeFiles(SurveyedDistrict& made, const Box2& box, const ReadSettings& reading,
                              const InputsScan& scan, Progress& progress, const std::stop_token& stop) {
    constexpr float everywhereM = 1e9F;
    const LonLatBox window = makeLonLatBox(made.ground.frame, glm::dvec2(box.low), glm::dvec2(box.high));
    NoProgress quiet;
    for (std::size_t i = 0; i < scan.buildings.size(); ++i) {
        if (scan.indexed[i] || !scan.boxes[i].touches(window)) continue;
        progress.report(double(i) / double(scan.buildings.size()), NM_TEXT("surveying the buildings"));
        const auto read =
            readCityExtent({scan.buildings[i]}, reading, {window, made.ground.terrain}, quiet, stop);
        if (!read) return tl::make_unexpected(read.error());
        made.survey.add(read->city, {glm::vec2(-everywhereM), glm::vec2(everywhereM)});
    }
    return {};
}

std::vector<std::filesystem::path> indexedFiles(const InputsScan& scan) {
    std::vector<std::filesystem::path> files;
    for (std::size_t i = 0; i < scan.buildings.size(); ++i)
        if (scan.indexed[i]) files.push_back(scan.buildings[i]);
    return files;
}

Result<void> surveyByExtent(SurveyedDistrict& made, const Box2& box, const ReadSettings& reading,
                            const InputsScan& scan, Progress& progress, const std::stop_token& stop) {
    const auto files = indexedFiles(scan);
    if (files.empty()) return {};
    NoProgress quiet;
    for (float y = box.low.y; y < box.high.y; y += blockM) {
        progress.report(double((y - box.low.y) / (box.high.y - box.low.y)),
                        NM_TEXT("surveying the buildings"));
        for (float x = box.low.x; x < box.high.x; x += blockM) {
            const Box2 block{{x, y}, {x + blockM, y + blockM}};
            if (!anyBuilding(scan.footprints, made.ground.frame, block)) continue;
            const Box2 around = grown(block, borderM);
            const ReadExtent window{
                makeLonLatBox(made.ground.frame, glm::dvec2(around.low), glm::dvec2(around.high)),
                made.ground.terrain};
            const auto read = readCityExtent(files, reading, window, quiet, stop);
            if (!read) return tl::make_unexpected(read.error());
            made.survey.add(read->city, block);
        }
    }
    return {};
}

// Each inventory once, wherever its trees stand.
Result<void> surveyTrees(SurveyedDistrict& made, const ReadSettings& reading, const std::stop_token& stop) {
    if (reading.treeFiles.empty()) return {};
    constexpr float everywhereM = 1e9F;
    NoProgress quiet;
    std::vector<ReadTree> trees;
    for (const std::string& file : reading.treeFiles) {
        auto read = readTrees(file, {.crs = reading.crs}, quiet, stop);
        if (!read) return tl::make_unexpected(read.error());
        std::ranges::move(read->trees, std::back_inserter(trees));
    }
    Warnings ofEachTask;
    City city = made.ground;
    city.trees = joinTrees(trees, city, reading.farAwayM, ofEachTask);
    made.survey.add(city, {glm::vec2(-everywhereM), glm::vec2(everywhereM)});
    return {};
}

Result<City> readGround(const District& district, const TaskPlanRequest& request, const InputsScan& scan,
                        Progress& progress, const std::stop_token& stop) {
    if (scan.terrain.empty()) return City{.frame = district.frame};
    return readCity(scan.terrain, readSettingsIn(district, request.reading), progress, stop)
        .map([](const CityRead& read) { return read.city; });
}

Result<SurveyedDistrict> surveyExtents(District& district, const TaskPlanRequest& request,
                                       const InputsScan& scan, Progress& progress,
                                       const std::stop_token& stop) {
    auto ground = readGround(district, request, scan, progress, stop);
    if (!ground) return tl::make_unexpected(ground.error());
    const ReadSettings reading = readSettingsIn(district, request.reading);
    const Box2 all = localBox(scan.footprints.box, district.frame);
    auto places = placesOver(district.frame, request, progress, stop);
    if (!places) return tl::make_unexpected(places.error());
    if (request.byPlace != nullptr && district.region.polygons.empty())
        if (auto taken = takePlacesAsRegion(district, *places, request); !taken)
            return tl::make_unexpected(taken.error());
    const bool whole = district.region.polygons.empty();
    Region region = whole ? makeRegionFromLocalBox(all) : district.region;
    auto sun = sunOver(*ground, request, region, stop);
    if (!sun) return tl::make_unexpected(sun.error());
    const Box2 measured = measuredBox(region, *places);
    Box2 box =
        whole ? grown(measured, borderM) : reachingBox(measured, scan, *ground, *sun, reading.farAwayM);
    box.add(grown(measured, reachOfTreesM(reading, *ground, *sun)));
    SurveyedDistrict made{OccluderSurvey(box), *ground, *std::move(sun), *std::move(places)};
    if (ground->terrain) made.survey.addTerrain(*ground->terrain);
    ReadSettings buildings = reading;
    buildings.treeFiles.clear();
    const auto surveyed =
        surveyWholeFiles(made, box, buildings, scan, progress, stop)
            .and_then([&] { return surveyByExtent(made, box, buildings, scan, progress, stop); })
            .and_then([&] { return surveyTrees(made, reading, stop); });
    if (!surveyed) return tl::make_unexpected(surveyed.error());
    if (!whole) return made;
    district.region = makeRegionFromLocalBox(made.survey.buildingsBox());
    district.region.name = "the whole city";
    return sunOver(*ground, request, district.region, stop).map([&](SunSteps own) {
        made.sun = std::move(own);
        return std::move(made);
    });
}

// The trees of cities of one project; those of cities that share all of them once.
std::shared_ptr<const Trees> unionOfTrees(std::span<const City* const> cities) {
    std::set<std::shared_ptr<const Trees>> known;
    Trees all;
    for (const City* city : cities) {
        if (!city->trees || !known.insert(city->trees).second) continue;
        all.leafDays = city->trees->leafDays;
        all.trees.insert(all.trees.end(), city->trees->trees.begin(), city->trees->trees.end());
    }
    return all.trees.empty() ? nullptr : std::make_shared<const Trees>(std::move(all));
}

// The buildings of cities of one project, those that they share once.
City unionOf(std::span<const City* const> cities) {
    City all;
    all.trees = unionOfTrees(cities);
    std::unordered_set<const Building*> known;
    for (const City* city : cities)
        for (const auto& building : city->buildings)
            if (known.insert(building.get()).second) all.buildings.push_back(building);
    return all;
}

// Cities of one frame and terrain.
Result<SurveyedDistrict> surveyCities(const District& district, std::span<const City* const> cities,
                                      const TaskPlanRequest& request, Progress& progress,
                                      const std::stop_token& stop) {
    auto places = placesOver(district.frame, request, progress, stop);
    if (!places) return tl::make_unexpected(places.error());
    Box2 box = measuredBox(district.region, *places);
    for (const City* city : cities) box.add(bounds(*city));
    City ground{.frame = district.frame, .terrain = cities.back()->terrain};
    auto sun = sunOver(ground, request, district.region, stop);
    if (!sun) return tl::make_unexpected(sun.error());
    SurveyedDistrict made{OccluderSurvey(grown(box, borderM)), std::move(ground), *std::move(sun),
                          *std::move(places)};
    if (made.ground.terrain) made.survey.addTerrain(*made.ground.terrain);
    made.survey.add(unionOf(cities), grown(box, borderM));
    return made;
}

Result<SurveyedDistrict> surveyWhole(District& district, const TaskPlanRequest& request, Progress& progress,
                                     const std::stop_token& stop) {
    auto read = readCity(pathsOf(request.files), request.reading, progress, stop);
    if (!read) return tl::make_unexpected(read.error());
    district.frame = read->city.frame;
    if (request.region == "city" && request.byPlace != nullptr) {
        const auto places = placesOver(district.frame, request, progress, stop);
        if (!places) return tl::make_unexpected(places.error());
        if (auto taken = takePlacesAsRegion(district, *places, request); !taken)
            return tl::make_unexpected(taken.error());
    } else if (request.region == "city") {
        district.region = makeRegionFromLocalBox(bounds(read->city));
        district.region.name = "the whole city";
    } else {
        auto region = readRegion(request.region, district.frame);
        if (!region) return tl::make_unexpected(region.error());
        district.region = *std::move(region);
    }
    const City* const cities[]{&read->city};
    return surveyCities(district, cities, request, progress, stop);
}

Result<SurveyedDistrict> surveySubject(District& district, const TaskPlanRequest& request, Progress& progress,
                                       const std::stop_token& stop) {
    std::vector<const City*> cities;
    for (const auto& city : request.subject->cities) cities.push_back(city.get());
    district.frame = cities.back()->frame;
    district.region = request.subject->region;
    return surveyCities(district, cities, request, progress, stop);
}

}  // namespace

Result<SurveyedDistrict> surveyDistrict(District& district, const TaskPlanRequest& request,
                                        const InputsScan& scan, Progress& progress,
                                        const std::stop_token& stop) {
    if (request.subject != nullptr) return surveySubject(district, request, progress, stop);
    return scan.byExtent ? surveyExtents(district, request, scan, progress, stop)
                         : surveyWhole(district, request, progress, stop);
}

}  // namespace noonmark
