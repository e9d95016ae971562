#include "core/city/footprints/plan_areas.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <iterator>

#include "core/city/meshes/mesh_outline.h"
#include "core/city/meshes/mesh_section.h"

namespace noonmark {

namespace {

// An edge that is not vertical, from west to east, relative to a common origin. The footprint is on the side
// below it where `sign` is positive.
struct Edge {
    double west, east;
    double y, slope;  // at `west`
    double sign;

    [[nodiscard]] double at(double x) const { return y + slope * (x - west); }
};

void addEdges(const Ring& ring, glm::dvec2 origin, const Box2& other, std::vector<Edge>& edges) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const glm::vec2 from = ring[i], to = ring[i + 1 == ring.size() ? 0 : i + 1];
        const auto [west, east] = from.x < to.x ? std::pair(from, to) : std::pair(to, from);
        const bool beside = east.x <= other.low.x || west.x >= other.high.x || west.x == east.x;
        // Below the other footprint an edge counts as often with its upper as with its lower side.
        if (beside || std::max(from.y, to.y) <= other.low.y) continue;
        const glm::dvec2 start = glm::dvec2(west) - origin, end = glm::dvec2(east) - origin;
        edges.push_back(
            {start.x, end.x, start.y, (end.y - start.y) / (end.x - start.x), from.x > to.x ? 1.0 : -1.0});
    }
}

std::vector<Edge> edgesOf(const Footprint& footprint, glm::dvec2 origin, const Box2& other) {
    std::vector<Edge> edges;
    addEdges(footprint.outer, origin, other, edges);
    for (const Ring& hole : footprint.holes) addEdges(hole, origin, other, edges);
    return edges;
}

// The area that lies below both edges and above the origin.
double computeAreaBelow(const Edge& a, const Edge& b) {
    const double west = std::max(a.west, b.west), east = std::min(a.east, b.east);
    if (west >= east) return 0;
    const double aWest = a.at(west), aEast = a.at(east), bWest = b.at(west), bEast = b.at(east);
    const double lowWest = std::min(aWest, bWest), lowEast = std::min(aEast, bEast);
    const double gapWest = aWest - bWest, gapEast = aEast - bEast;
    const bool cross = (gapWest < 0) != (gapEast < 0) && gapWest != gapEast;
    if (!cross) return (lowWest + lowEast) / 2 * (east - west);
    const double middle = west + (east - west) * gapWest / (gapWest - gapEast);
    const double lowMiddle = a.at(middle);
    return (lowWest + lowMiddle) / 2 * (middle - west) + (lowMiddle + lowEast) / 2 * (east - middle);
}

bool haveSharedBox(const Box2& a, const Box2& b) {
    return a.low.x < b.high.x && b.low.x < a.high.x && a.low.y < b.high.y && b.low.y < a.high.y;
}

double computeSharedArea(const Footprint& a, const Footprint& b, const Box2& aBox, const Box2& bBox) {
    if (!haveSharedBox(aBox, bBox)) return 0;
    const glm::dvec2 origin(glm::max(aBox.low.x, bBox.low.x), glm::min(aBox.low.y, bBox.low.y));
    const std::vector<Edge> first = edgesOf(a, origin, bBox), second = edgesOf(b, origin, aBox);
    double sum = 0;
    for (const Edge& one : first)
        for (const Edge& other : second) sum += one.sign * other.sign * computeAreaBelow(one, other);
    return std::max(0.0, sum);
}

std::vector<Box2> boxesOf(const std::vector<Footprint>& footprints) {
    std::vector<Box2> boxes;
    for (const Footprint& footprint : footprints) boxes.push_back(bounds(footprint));
    return boxes;
}

}  // namespace

std::size_t countPoints(const std::vector<Footprint>& footprints) {
    std::size_t count = 0;
    for (const Footprint& footprint : footprints) {
        count += footprint.outer.size();
        for (const Ring& hole : footprint.holes) count += hole.size();
    }
    return count;
}

double computeSharedArea(const Footprint& a, const Footprint& b) {
    return computeSharedArea(a, b, bounds(a), bounds(b));
}

// Bonferroni's inequalities: one cover after the other is taken off, which is too much by what two share.
OutsideArea boundAreaOutside(const std::vector<Footprint>& pieces, const std::vector<Footprint>& others) {
    constexpr std::size_t maxPairs = 1'000'000;
    const double whole = area(pieces);
    const std::size_t points = countPoints(others);
    if ((countPoints(pieces) + points) * points > maxPairs) return {0, whole};
    const std::vector<Box2> pieceBoxes = boxesOf(pieces), otherBoxes = boxesOf(others);
    double covered = 0, twice = 0;
    for (std::size_t i = 0; i < others.size(); ++i) {
        for (std::size_t p = 0; p < pieces.size(); ++p)
            covered += computeSharedArea(pieces[p], others[i], pieceBoxes[p], otherBoxes[i]);
        for (std::size_t j = 0; j < i; ++j)
            twice += computeSharedArea(others[j], others[i], otherBoxes[j], otherBoxes[i]);
    }
    return {std::max(0.0, whole - covered), std::min(whole, whole - covered + twice)};
}

namespace {

constexpr double aboveFloorM = 0.01;

struct Storey {
    double floorM, middleM;  // local z
};

Storey storeyAt(int number, double groundM, double storeyHeightM) {
    return {groundM + number * storeyHeightM, groundM + (number + 0.5) * storeyHeightM};
}

std::vector<const Part*> partsThrough(const Building& building, double heightM) {
    std::vector<const Part*> parts;
    for (const Part& part : building.parts)
        if (double(part.bottomM) <= heightM && heightM < double(part.topM)) parts.push_back(&part);
    return parts;
}

struct Floor {
    std::vector<Footprint> pieces;
    bool estimated = false;
};

Floor floorOf(const std::vector<const Part*>& parts, double floorM) {
    Floor floor;
    for (const Part* part : parts) {
        if (!part->mesh) {
            floor.pieces.push_back(part->footprint);
            continue;
        }
        MeshSection section = cutSection(*part->mesh, std::max(floorM, double(part->bottomM)) + aboveFloorM);
        std::ranges::move(section.pieces, std::back_inserter(floor.pieces));
        floor.estimated = floor.estimated || section.estimated;
    }
    if (parts.size() > 1) floor.pieces = computeUnion(floor.pieces);
    return floor;
}

bool arePrisms(const std::vector<const Part*>& parts) {
    return std::ranges::all_of(parts, [](const Part* part) { return !part->mesh; });
}

int storeysOf(const Building& building, double groundM, double storeyHeightM) {
    constexpr double maximum = 10'000;
    const double storeys = (double(topM(building)) - groundM) / storeyHeightM;
    return storeys > 0 ? int(std::min(maximum, std::ceil(storeys))) : 0;
}

}  // namespace

FloorArea computeFloorArea(const Building& building, double groundM, double storeyHeightM) {
    FloorArea all;
    std::vector<const Part*> before;
    double areaM2 = 0;
    for (int i = 0; i < storeysOf(building, groundM, storeyHeightM); ++i) {
        const Storey storey = storeyAt(i, groundM, storeyHeightM);
        const std::vector<const Part*> parts = partsThrough(building, storey.middleM);
        bool estimated = false;
        if (parts != before || !arePrisms(parts)) {
            const Floor floor = floorOf(parts, storey.floorM);
            areaM2 = area(floor.pieces);
            estimated = floor.estimated;
        }
        before = parts;
        all.grossM2 += areaM2;
        all.storeys += areaM2 > 0 ? 1 : 0;
        all.estimatedStoreys += areaM2 > 0 && estimated ? 1 : 0;
    }
    return all;
}

std::vector<Footprint> findGroundFloor(const Building& building, double groundM, double storeyHeightM) {
    const Storey storey = storeyAt(0, groundM, storeyHeightM);
    return floorOf(partsThrough(building, storey.middleM), storey.floorM).pieces;
}

}  // namespace noonmark
