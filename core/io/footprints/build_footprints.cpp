#include "core/io/footprints/build_footprints.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>
#include <algorithm>
#include <iterator>
#include <limits>

#include "core/city/footprints/plan_areas.h"
#include "core/city/footprints/plan_overlay.h"
#include "core/city/meshes/mesh_outline.h"
#include "core/describe/text.h"

namespace noonmark {

namespace {

/// The area of an outline that its parts leave uncovered.
struct OutlineRemainder {
    std::vector<Footprint> pieces;  ///< none if the parts cover the outline
    double bottomM = 0;             ///< above the ground
    double topM = 0;
    HeightSource source = HeightSource::assumed;
    bool guessed = false;  ///< topM is not the height stated for the outline
};

/// Parts replace the outline of their building where they occupy some of its height; a part that begins above
/// the outline's stated height (a tower on a podium, with the podium as the outline) replaces nothing. The
/// uncovered rest, in pieces of at least 10 m2 that are 1 m wide somewhere, is built too. Its height:
/// - The outline's own height, if that cannot be the height of the building's tallest part: parts rise over
///   10 % above it (50 % if it was counted from storeys), or none reaches half of it.
/// - Otherwise the outline's height is that of the tallest part and says nothing about the rest. It then gets
///   the lowest top of the parts that stand on the ground, or the lowest underside if no part does; never
///   more than the outline's height.
OutlineRemainder computeRemainder(const PlacedFeature& outline,
                                  const std::vector<const PlacedFeature*>& parts);

using Parts = std::vector<const PlacedFeature*>;

bool isStated(const HeightReading& heights) { return heights.source != HeightSource::assumed; }

// The parts that occupy some of the outline's height.
Parts replacing(const HeightReading& outline, const Parts& parts) {
    if (!isStated(outline)) return parts;
    Parts found;
    for (const PlacedFeature* part : parts)
        if (part->facts.heights.bottomM < outline.topM - 0.01) found.push_back(part);
    return found;
}

bool ownHeightHolds(const HeightReading& outline, const Parts& parts) {
    if (!isStated(outline)) return false;
    double tallest = 0;
    for (const PlacedFeature* part : parts) tallest = std::max(tallest, part->facts.heights.topM);
    const double slack = outline.source == HeightSource::levels ? 1.5 : 1.1;
    return tallest > slack * outline.topM || tallest < 0.5 * outline.topM;
}

double guessedTop(const HeightReading& outline, const Parts& parts) {
    constexpr double far = std::numeric_limits<double>::max();
    double lowestTop = far;
    double lowestUnderside = far;
    for (const PlacedFeature* part : parts) {
        const HeightReading& heights = part->facts.heights;
        if (heights.bottomM <= 0)
            lowestTop = std::min(lowestTop, heights.topM);
        else
            lowestUnderside = std::min(lowestUnderside, heights.bottomM);
    }
    const double top = lowestTop < far ? lowestTop : lowestUnderside;
    return isStated(outline) ? std::min(top, outline.topM) : top;
}

OutlineRemainder computeRemainder(const PlacedFeature& outline, const Parts& parts) {
    const HeightReading& own = outline.facts.heights;
    OutlineRemainder rest{outline.pieces, own.bottomM, own.topM, own.source, false};
    const Parts covering = replacing(own, parts);
    if (covering.empty()) return rest;
    std::vector<Footprint> cover;
    for (const PlacedFeature* part : covering)
        cover.insert(cover.end(), part->pieces.begin(), part->pieces.end());
    rest.pieces = cutPiecesOutside(outline.pieces, cover, {});
    if (ownHeightHolds(own, covering)) return rest;
    rest.topM = guessedTop(own, covering);
    rest.source = HeightSource::assumed;
    rest.guessed = true;
    if (rest.bottomM > rest.topM - minHeightM) rest.bottomM = 0;
    return rest;
}

using Features = std::vector<PlacedFeature>;

double computeArea(const PlacedFeature& feature) { return area(feature.pieces); }

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

std::string explainGdalWarning(std::string_view words) {
    const auto says = [&](std::string_view piece) { return words.find(piece) != words.npos; };
    if (says("Non closed ring"))
        return "outlines were not closed, as happens at the edge of an extract; the last point of each was "
               "connected to its first";
    if (says("processing may be really slow")) return {};
    if (says("organizePolygons()") || says("translated to Simple Geometry"))
        return "outer rings and holes of an outline could not be distinguished; each ring was taken as a "
               "polygon";
    return "message of the map library: " + std::string(words);
}

void addMapRemarks(const std::vector<std::string>& words, const std::string& file, Warnings& warnings) {
    Warnings remarks;
    for (const std::string& one : words)
        if (std::string what = explainGdalWarning(one); !what.empty())
            remarks.push_back({WarningKind::repaired, std::move(what), file});
    for (const WarningGroup& group : groupWarnings(remarks))
        warnings.push_back({group.kind, group.what, fmt::format("{} ({})", file, group.where.size())});
}

namespace {

void addBuildings(FilePiece& piece, std::vector<AssembledBuilding> buildings, const Frame& frame) {
    const std::size_t first = piece.buildings.size();
    piece.groundM.resize(first + buildings.size());
    piece.buildings.resize(first + buildings.size());
    if (std::ranges::any_of(buildings, [](const auto& made) { return made.roof.has_value(); }))
        piece.roofs.resize(first + buildings.size());
    tbb::parallel_for(std::size_t{0}, buildings.size(), [&](std::size_t i) {
        AssembledBuilding& made = buildings[i];
        std::optional<float>& ground = piece.groundM[first + i];
        if (made.elevationM) ground = float(*made.elevationM - frame.originElevationM());
        if (!piece.roofs.empty()) piece.roofs[first + i] = std::move(made.roof);
        for (Part& part : made.building.parts) {
            part.bottomM += ground.value_or(0);
            part.topM += ground.value_or(0);
        }
        piece.buildings[first + i] = std::make_shared<const Building>(std::move(made.building));
    });
}

}  // namespace

Result<void> buildFootprints(FilePiece& piece, std::vector<UnplacedFeature> features,
                             const ReadSettings& settings, Progress& progress, const std::stop_token& stop) {
    if (!settings.frame) piece.frame = frameOf(features, settings.farAwayM);
    const Frame frame = settings.frame ? *settings.frame : *piece.frame;
    progress.report(shareOfReading, NM_TEXT("repairing outlines"));
    const auto placed = placeFeatures(std::move(features), frame, settings.farAwayM, piece.warnings, stop);
    progress.report(0.9, NM_TEXT("making buildings"));
    addBuildings(piece, assembleBuildings(placed, settings.metresPerLevel, piece.warnings, stop), frame);
    if (stop.stop_requested()) return cancelled();
    progress.report(1, NM_TEXT("making buildings"));
    return {};
}

std::string findMostFrequent(const Warnings& warnings) {
    const auto groups = groupWarnings(warnings);
    const auto maximum =
        std::ranges::max_element(groups, {}, [](const WarningGroup& group) { return group.where.size(); });
    return maximum == groups.end() ? "" : lineOf(*maximum);
}

namespace {

constexpr float sameHeightM = 0.01F;

bool meet(const Box2& a, const Box2& b) {
    return a.low.x < b.high.x && b.low.x < a.high.x && a.low.y < b.high.y && b.low.y < a.high.y;
}

using PartRefs = std::vector<const Part*>;

PartRefs carriersOf(const Part& part, const PartRefs& standing, float reachM) {
    PartRefs carriers;
    const Box2 box = bounds(part.footprint);
    for (const Part* lower : standing)
        if (lower->topM >= part.bottomM - reachM && meet(box, bounds(lower->footprint)))
            carriers.push_back(lower);
    return carriers;
}

bool isCarried(const Part& part, const PartRefs& carriers) {
    if (carriers.empty()) return false;
    std::vector<Footprint> footprints;
    for (const Part* carrier : carriers) footprints.push_back(carrier->footprint);
    constexpr double roundingM2 = 1e-4;
    const double openM2 = std::max(0.5, 0.05 * area(part.footprint));
    const OutsideArea outside = boundAreaOutside({part.footprint}, footprints);
    if (outside.maxM2 < openM2 - roundingM2) return true;
    if (outside.minM2 > openM2 + roundingM2) return false;
    return computeAreaOutside(part.footprint, footprints) <= openM2;
}

float lowestTop(const PartRefs& carriers) {
    return (*std::ranges::min_element(carriers, {}, [](const Part* part) { return part->topM; }))->topM;
}

void lower(Part& part, float bottomM, Warnings& warnings) {
    part.bottomM = bottomM;
    warnings.push_back({WarningKind::repaired, "a low gap under a raised part was closed", part.sourceId});
}

void settle(Part& part, const PartRefs& standing, const SettleRules& rules, Warnings& warnings) {
    if (part.bottomM <= rules.groundM + sameHeightM) return;
    if (isCarried(part, carriersOf(part, standing, sameHeightM))) return;
    const PartRefs near = carriersOf(part, standing, rules.carryGapM);
    if (isCarried(part, near)) return lower(part, std::min(part.bottomM, lowestTop(near)), warnings);
    if (part.bottomM <= rules.groundM + rules.groundGapM) return lower(part, rules.groundM, warnings);
    part.isOverhanging = true;
}

}  // namespace

void settleParts(std::vector<Part>& parts, const SettleRules& rules, Warnings& warnings) {
    std::vector<Part*> upward;
    for (Part& part : parts)
        if (!part.isOverhanging) upward.push_back(&part);
    std::ranges::stable_sort(upward, {}, [](const Part* part) { return part->bottomM; });
    PartRefs standing;
    for (Part* part : upward) {
        settle(*part, standing, rules, warnings);
        if (!part->isOverhanging) standing.push_back(part);
    }
}

}  // namespace noonmark
