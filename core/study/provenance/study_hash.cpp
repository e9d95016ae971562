#include "core/study/provenance/study_hash.h"

#include <fmt/format.h>

#include "core/base/version.h"
#include "core/city/footprints/repair_footprint.h"
#include "core/city/map_context.h"
#include "core/city/trees/tree.h"
#include "core/describe/field_values.h"
#include "core/receivers/roof_receivers.h"
#include "core/study/provenance/sha256.h"
#include "core/study/study_fields.h"

namespace noonmark {

namespace {

// Increase this number whenever the same study gives other results, so that older tiles are not resumed. 2:
// the sun is in the frame of the geometry, and rays decide doubtful longest runs. 3: water is no ground.
constexpr std::uint32_t methodNumber = 3;

template <class T>
void addAll(Sha256& sum, const std::vector<T>& values) {
    sum.add(values.size());
    sum.add(values.data(), values.size() * sizeof(T));
}

// Hashes the number of points first, so that consecutive rings are delimited.
void addFootprint(Sha256& sum, const Footprint& footprint) {
    addAll(sum, footprint.outer);
    sum.add(footprint.holes.size());
    for (const Ring& hole : footprint.holes) addAll(sum, hole);
}

void addPart(Sha256& sum, const Part& part) {
    addFootprint(sum, part.footprint);
    sum.add(part.bottomM);
    sum.add(part.topM);
    sum.add(part.isOverhanging);
    sum.add(bool(part.mesh));
    if (!part.mesh) return;
    addAll(sum, part.mesh->vertices);
    addAll(sum, part.mesh->triangles);
}

// Hashes everything that determines the positions of the posts.
void addPosts(Sha256& sum, const PostGrid& posts) {
    for (const glm::dvec2 way : {posts.first, posts.columnStep, posts.rowStep}) {
        sum.add(way.x);
        sum.add(way.y);
    }
    sum.add(posts.columns);
    sum.add(posts.rows);
    for (const glm::dvec2 term : posts.bend) {
        sum.add(term.x);
        sum.add(term.y);
    }
}

// What of the map decides where the ground is. Nothing where there is no water.
void addWater(Sha256& sum, const MapContext& map) {
    for (const ContextArea& area : map.areas) {
        if (area.kind != ContextKind::water) continue;
        sum.add(area.polygons.size());
        for (const Footprint& polygon : area.polygons) addFootprint(sum, polygon);
    }
}

void addTree(Sha256& sum, const Tree& tree) {
    sum.add(tree.place.x);
    sum.add(tree.place.y);
    for (const float number : {tree.groundM, tree.heightM, tree.crownBaseM, tree.crownDiameterM,
                               tree.leafOnTransmissivity, tree.leafOffTransmissivity})
        sum.add(number);
    sum.add(int(tree.shape));
    sum.add(tree.evergreen);
    if (!tree.leafOnDay && !tree.leafOffDay) return;  // as trees were hashed before they had such days
    sum.add(tree.leafOnDay.value_or(0));
    sum.add(tree.leafOffDay.value_or(0));
}

void addTrees(Sha256& sum, const Trees& trees) {
    sum.add(trees.leafDays.on);
    sum.add(trees.leafDays.off);
    for (const Tree& tree : trees.trees) addTree(sum, tree);
}

void addCity(Sha256& sum, const City& city) {
    const LonLat origin = city.frame.origin();
    for (const double number : {origin.lonDeg, origin.latDeg, city.frame.originElevationM()}) sum.add(number);
    sum.add(city.buildings.size());
    for (const auto& building : city.buildings) {
        sum.add(building->parts.size());
        for (const Part& part : building->parts) addPart(sum, part);
    }
    sum.add(bool(city.terrain));
    if (city.terrain) {
        addPosts(sum, city.terrain->grid);
        addAll(sum, city.terrain->elevationM);
    }
    if (city.context) addWater(sum, *city.context);
    if (city.trees) addTrees(sum, *city.trees);
}

void addRegion(Sha256& sum, const Region& region) {
    for (const Footprint& polygon : region.polygons) addFootprint(sum, polygon);
}

// Frozen: results saved by earlier versions state hashes made from it.
void addSettingsOfVersion1(Sha256& sum, const StudySettings& settings) {
    const Period& period = settings.period;
    sum.add(fmt::format("{};{};{};{};{};{};", formatText(period), period.hours, period.stepMinutes,
                        period.refraction, settings.pressureHPa, settings.temperatureC));
    if (period.window) sum.add(fmt::format("{};", int(period.window->rule)));
    sum.add(fmt::format("{};{};{};{};", settings.receivers.cellM, settings.engine, 300, 1));
    if (settings.receivers.places != ReceiverPlaces::ground)
        sum.add(fmt::format("{};", nameOf(settings.receivers.places)));
    for (const auto& [key, value] : settings.engineSettings) sum.add(fmt::format("{}={};", key, value));
    addRegion(sum, settings.region);
}

// The region as a file gives it back, which is repaired when it is read.
Region repaired(const Region& region) {
    Region made{region.name, {}};
    for (const Footprint& polygon : region.polygons) {
        std::vector<RawRing> rings{RawRing(polygon.outer.begin(), polygon.outer.end())};
        for (const Ring& hole : polygon.holes) rings.emplace_back(hole.begin(), hole.end());
        for (Footprint& piece : repairFootprint(rings).pieces) made.polygons.push_back(std::move(piece));
    }
    return made;
}

}  // namespace

std::string hashQuestion(const StudySettings& settings) {
    Sha256 sum;
    sum.add(questionText(studyFields().of(settings)));
    addRegion(sum, repaired(settings.region));
    return "2:" + sum.hex();
}

QuestionHashes listHashes(const StudySettings& settings) {
    StudySettings question = settings;
    question.region = repaired(settings.region);
    Sha256 sum;
    addSettingsOfVersion1(sum, question);
    return {hashQuestion(settings), sum.hex()};
}

std::string hashSettings(const StudySettings& settings) {
    Sha256 sum;
    sum.add(version());
    sum.add(methodNumber);
    sum.add(questionText(studyFields().of(settings), true));
    addRegion(sum, settings.region);
    return sum.hex();
}

std::string hashBuilding(const Building& building) {
    Sha256 sum;
    for (const Part& part : building.parts) addPart(sum, part);
    return sum.hex();
}

std::string hashTree(const Tree& tree, const LeafDays& leafDays) {
    Sha256 sum;
    sum.add(leafDays.on);
    sum.add(leafDays.off);
    addTree(sum, tree);
    return sum.hex();
}

std::string hashCity(const City& city) {
    Sha256 sum;
    addCity(sum, city);
    return sum.hex();
}

std::string hashStudy(const City& city, const StudySettings& settings) {
    Sha256 sum;
    addCity(sum, city);
    sum.add(hashSettings(settings));
    return sum.hex();
}

}  // namespace noonmark
