#include "scenarios/massing/lot_edits.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "core/city/footprints/plan_overlay.h"
#include "core/city/footprints/repair_footprint.h"
#include "core/city/terrain/building_ground.h"
#include "core/describe/text.h"
#include "scenarios/edits/placed_building.h"
#include "scenarios/massing/copy_massing.h"

namespace noonmark {

namespace {

constexpr double straightSine =
    0.005;  // 0.3 degrees: sides that lie so far apart in direction go on straight

double cross(glm::dvec2 a, glm::dvec2 b) { return a.x * b.y - a.y * b.x; }

glm::dvec2 cornerAt(const Ring& ring, std::size_t i) { return glm::dvec2(ring[i % ring.size()]); }

bool isSimple(const Footprint& shape) {
    std::vector<RawRing> rings;
    rings.emplace_back(shape.outer.begin(), shape.outer.end());
    for (const Ring& hole : shape.holes) rings.emplace_back(hole.begin(), hole.end());
    const RepairedFootprint repaired = repairFootprint(rings);
    return repaired.what.empty() && repaired.pieces.size() == 1 &&
           repaired.pieces.front().holes.size() == shape.holes.size();
}

Result<Footprint> checkedLot(const Footprint& lot, Ring outer) {
    Footprint changed{std::move(outer), lot.holes};
    if (signedArea(changed.outer) < 0) std::ranges::reverse(changed.outer);
    if (!isSimple(changed))
        return failure(NM_TEXT("The sides of the lot would cross or touch each other"), {},
                       NM_TEXT("Move the corner or side less far"));
    return changed;
}

// Where the side through a corner of the edge meets the moved edge. `from`: the side's other end.
glm::dvec2 meetMoved(glm::dvec2 from, glm::dvec2 corner, glm::dvec2 edge, glm::dvec2 byM) {
    const glm::dvec2 side = corner - from;
    return corner + side * (cross(byM, edge) / cross(side, edge));
}

bool goesStraight(glm::dvec2 side, glm::dvec2 edge) {
    return std::abs(cross(side, edge)) <= straightSine * glm::length(side) * glm::length(edge);
}

// One corner where the side and the moved edge meet, or two where the side goes on straight.
std::vector<glm::dvec2> cornersAfter(glm::dvec2 from, glm::dvec2 corner, glm::dvec2 edge, glm::dvec2 byM) {
    if (goesStraight(corner - from, edge)) return {corner, corner + byM};
    return {meetMoved(from, corner, edge, byM)};
}

// Half the plane beyond the point where two sides that lean together meet holds no lot.
bool turnsRound(const std::vector<glm::dvec2>& first, const std::vector<glm::dvec2>& last, glm::dvec2 edge) {
    return glm::dot(last.back() - first.back(), edge) <= 0;
}

}  // namespace

glm::dvec2 outwardOf(const Footprint& lot, std::size_t edge) {
    const glm::dvec2 along = cornerAt(lot.outer, edge + 1) - cornerAt(lot.outer, edge);
    return glm::normalize(glm::dvec2(along.y, -along.x));
}

Result<Footprint> moveCorner(const Footprint& lot, std::size_t corner, glm::dvec2 to) {
    Ring outer = lot.outer;
    outer[corner] = glm::vec2(to);
    return checkedLot(lot, std::move(outer));
}

Result<Footprint> moveEdge(const Footprint& lot, std::size_t edge, double byM) {
    const std::size_t count = lot.outer.size();
    const glm::dvec2 a = cornerAt(lot.outer, edge), b = cornerAt(lot.outer, edge + 1);
    const glm::dvec2 by = byM * outwardOf(lot, edge);
    if (byM == 0) return lot;
    const auto first = cornersAfter(cornerAt(lot.outer, edge + count - 1), a, b - a, by);
    const auto last = cornersAfter(cornerAt(lot.outer, edge + 2), b, b - a, by);
    if (turnsRound(first, last, b - a))
        return failure(NM_TEXT("The sides beside it meet before that"), {},
                       NM_TEXT("Move the side less far"));
    Ring outer;
    for (const glm::dvec2 point : first) outer.emplace_back(point);
    for (auto point = last.rbegin(); point != last.rend(); ++point) outer.emplace_back(*point);
    for (std::size_t i = edge + 2; i < edge + count; ++i) outer.push_back(lot.outer[i % count]);
    return checkedLot(lot, std::move(outer));
}

Result<Footprint> insertCorner(const Footprint& lot, std::size_t edge) {
    const glm::dvec2 middle = (cornerAt(lot.outer, edge) + cornerAt(lot.outer, edge + 1)) / 2.0;
    Ring outer = lot.outer;
    outer.insert(outer.begin() + std::ptrdiff_t(edge) + 1, glm::vec2(middle));
    return checkedLot(lot, std::move(outer));
}

Result<Footprint> removeCorner(const Footprint& lot, std::size_t corner) {
    if (lot.outer.size() <= 3)
        return failure(NM_TEXT("A lot needs three corners or more"), {}, NM_TEXT("Move the corner instead"));
    Ring outer = lot.outer;
    outer.erase(outer.begin() + std::ptrdiff_t(corner));
    return checkedLot(lot, std::move(outer));
}

std::vector<Footprint> computeOutline(const Building& building) {
    constexpr MinPiece minimum{.areaM2 = 1, .widthM = 0};
    const auto lowest = std::ranges::min_element(building.parts, {}, &Part::bottomM);
    std::vector<Footprint> standing, all;
    for (const Part& part : building.parts) {
        all.push_back(part.footprint);
        if (reachesGround(part, lowest->bottomM)) standing.push_back(part.footprint);
    }
    return cutPiecesOutside(standing.empty() ? all : standing, {}, minimum);
}

std::vector<Edit> clearing(const City& city, const Footprint& lot) {
    const Box2 box = bounds(lot);
    std::vector<Edit> edits;
    for (const auto& building : city.buildings) {
        const Box2 other = bounds(*building);
        const bool near = other.low.x < box.high.x && box.low.x < other.high.x && other.low.y < box.high.y &&
                          box.low.y < other.high.y;
        if (near && contains(lot, findMiddle(*building))) edits.emplace_back(Demolish{building->sourceId});
    }
    return edits;
}

Result<Variant> makeVariant(const City& city, std::size_t building, const Footprint& lot, double plateFactor,
                            double storeyHeightM) {
    const Building& old = *city.buildings[building];
    const auto given = massOf(old, double(findGroundUnder(old, city)), storeyHeightM);
    if (!given) return tl::make_unexpected(given.error());
    auto massing = findSameFloorArea(lot, *given, plateFactor);
    if (!massing) return failure(massing.error().what, old.sourceId, massing.error().advice);
    auto made = buildingOf(*massing, old.sourceId);
    if (!made) return tl::make_unexpected(made.error());
    made->name = old.name;
    auto shape = std::make_shared<const Building>(*std::move(made));
    return Variant{{old.sourceId, std::move(shape)}, *std::move(massing), given->grossFloorM2};
}

}  // namespace noonmark
