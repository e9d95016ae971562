#include "core/io/footprints/osm_semantics.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <iterator>

#include "core/city/settle_parts.h"
#include "core/io/footprints/outline_remainder.h"

namespace noonmark {

namespace {

using Features = std::vector<PlacedFeature>;

double computeArea(const PlacedFeature& feature) {
    double sum = 0;
    for (const Footprint& piece : feature.pieces) sum += area(piece);
    return sum;
}

// The feature that gives the building its name: its outline, else its largest part.
const PlacedFeature& headOf(const BuildingGroup& group, const Features& features) {
    if (group.outline) return features[*group.outline];
    return features[*std::ranges::max_element(group.parts, {},
                                              [&](std::size_t i) { return computeArea(features[i]); })];
}

void addPieces(Building& building, const PlacedFeature& feature, Warnings& warnings) {
    const HeightReading& heights = feature.facts.heights;
    if (heights.byDefault)
        warnings.push_back({WarningKind::assumed,
                            fmt::format("{}; {:g} m is assumed", noHeightInData, heights.topM),
                            feature.facts.id});
    for (const Footprint& piece : feature.pieces)
        building.parts.push_back({.sourceId = feature.facts.id,
                                  .footprint = piece,
                                  .bottomM = float(heights.bottomM),
                                  .topM = float(heights.topM),
                                  .heightSource = heights.source,
                                  .isOverhanging = feature.facts.isOverhanging.value_or(heights.slab)});
}

void addRemainder(Building& building, const PlacedFeature& outline,
                  const std::vector<const PlacedFeature*>& parts, Warnings& warnings) {
    OutlineRemainder rest = computeRemainder(outline, parts);
    if (rest.pieces.empty()) return;
    if (rest.guessed)
        warnings.push_back({WarningKind::assumed,
                            "its parts leave some of its outline uncovered; that area is given the height of "
                            "its lowest part",
                            outline.facts.id});
    PlacedFeature feature{outline.facts, std::move(rest.pieces)};
    feature.facts.heights.bottomM = rest.bottomM;
    feature.facts.heights.topM = rest.topM;
    feature.facts.heights.source = rest.source;
    feature.facts.heights.byDefault &= !rest.guessed;
    addPieces(building, feature, warnings);
}

// Uses what the features state about overhangs; otherwise decides by what is below each raised part.
void settle(Building& building, const BuildingGroup& group, const Features& features, double metresPerLevel,
            Warnings& warnings) {
    const bool stated = std::ranges::any_of(
        group.parts, [&](std::size_t i) { return features[i].facts.isOverhanging.has_value(); });
    if (stated) return;
    settleParts(building.parts, {.groundM = 0, .carryGapM = float(metresPerLevel)}, warnings);
}

std::optional<double> lowestGround(const BuildingGroup& group, const Features& features) {
    std::optional<double> lowest;
    const auto look = [&](std::size_t i) {
        const auto ground = features[i].facts.heights.groundElevationM;
        if (ground) lowest = std::min(lowest.value_or(*ground), *ground);
    };
    if (group.outline) look(*group.outline);
    for (const std::size_t part : group.parts) look(part);
    return lowest;
}

// Of a building of one feature: parts stand on each other.
std::optional<RoofElevation> roofOf(const BuildingGroup& group, const Features& features) {
    if (group.parts.empty()) return features[*group.outline].facts.heights.roof;
    if (group.parts.size() > 1 || group.outline.value_or(group.parts[0]) != group.parts[0])
        return std::nullopt;
    return features[group.parts[0]].facts.heights.roof;
}

AssembledBuilding assemble(const BuildingGroup& group, const Features& features, double metresPerLevel,
                           Warnings& warnings) {
    const FeatureFacts& head = headOf(group, features).facts;
    Building building{.sourceId = head.buildingId.empty() ? head.id : head.buildingId,
                      .name = head.name,
                      .status = head.status};
    std::vector<const PlacedFeature*> parts;
    for (const std::size_t i : group.parts) parts.push_back(&features[i]);
    const bool outlineIsPart =
        group.outline && std::ranges::find(group.parts, *group.outline) != group.parts.end();
    if (group.outline && !outlineIsPart) addRemainder(building, features[*group.outline], parts, warnings);
    for (const PlacedFeature* part : parts) addPieces(building, *part, warnings);
    settle(building, group, features, metresPerLevel, warnings);
    return {std::move(building), lowestGround(group, features), roofOf(group, features)};
}

}  // namespace

std::vector<AssembledBuilding> assembleBuildings(const Features& features, double metresPerLevel,
                                                 Warnings& warnings, const std::stop_token& stop) {
    const std::vector<BuildingGroup> groups = groupIntoBuildings(features);
    std::vector<AssembledBuilding> buildings(groups.size());
    std::vector<Warnings> remarks(groups.size());
    tbb::parallel_for(std::size_t{0}, groups.size(), [&](std::size_t i) {
        if (!stop.stop_requested()) buildings[i] = assemble(groups[i], features, metresPerLevel, remarks[i]);
    });
    for (Warnings& some : remarks) std::ranges::move(some, std::back_inserter(warnings));
    std::erase_if(buildings, [](const AssembledBuilding& made) { return made.building.parts.empty(); });
    return buildings;
}

}  // namespace noonmark
