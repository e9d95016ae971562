#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "core/city/footprints/geos_shapes.h"
#include "core/receivers/parcels/parcel_roads.h"

namespace noonmark {

namespace {

/// An edge of the parcel, and how far its line moves out.
struct Edge {
    glm::dvec2 from, to;
    glm::dvec2 outward;  // unit vector
    double shiftM = 0;
};

/// Degrees between where an edge faces and the middle of a side, 0 to 180.
double awayFrom(ParcelSide side, glm::dvec2 outward) {
    constexpr double degreesPerRadian = 180 / std::numbers::pi;
    const double azimuth = std::atan2(outward.x, outward.y) * degreesPerRadian;
    return std::abs(std::remainder(azimuth - 45.0 * int(side), 360.0));
}

double shiftAlong(glm::dvec2 outward, const std::vector<RoadFront>& roads, const RoadShift& rule) {
    const auto away = [&](const RoadFront& road) { return awayFrom(road.side, outward); };
    const auto nearest = std::ranges::min_element(roads, {}, away);
    if (nearest == roads.end() || away(*nearest) > 45) return 0;
    return std::max(0.0, shiftOf(rule, nearest->widthM));
}

std::vector<Edge> edgesOf(const Ring& ring, const std::vector<RoadFront>& roads, const RoadShift& rule) {
    std::vector<Edge> edges;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const glm::dvec2 from(ring[i]), to(ring[(i + 1) % ring.size()]);
        if (from == to) continue;
        const glm::dvec2 along = glm::normalize(to - from);
        const glm::dvec2 outward(along.y, -along.x);  // the ring runs counter-clockwise
        edges.push_back({from, to, outward, shiftAlong(outward, roads, rule)});
    }
    return edges;
}

Footprint polygonOf(std::initializer_list<glm::dvec2> points) {
    Footprint polygon;
    for (const glm::dvec2 point : points) polygon.outer.emplace_back(point);
    return polygon;
}

/// The ground between two strips at a corner that points outwards; very sharp corners are cut.
Footprint cornerOf(const Edge& before, const Edge& after) {
    constexpr double longestMiter = 4;  // in shifts
    const glm::dvec2 corner = after.from;
    const glm::dvec2 a = corner + before.outward * before.shiftM, b = corner + after.outward * after.shiftM;
    const double cross = before.outward.x * after.outward.y - before.outward.y * after.outward.x;
    const glm::dvec2 meets = glm::dvec2(before.shiftM * after.outward.y - after.shiftM * before.outward.y,
                                        after.shiftM * before.outward.x - before.shiftM * after.outward.x) /
                             cross;
    if (glm::length(meets) > longestMiter * std::max(before.shiftM, after.shiftM))
        return polygonOf({corner, a, b});
    return polygonOf({corner, a, corner + meets, b});
}

bool pointsOutwards(const Edge& before, const Edge& after) {
    constexpr double nearlyStraight = 1e-4;
    return before.outward.x * after.outward.y - before.outward.y * after.outward.x > nearlyStraight;
}

}  // namespace

Result<std::vector<Footprint>> moveLineOut(const Footprint& parcel, const std::vector<RoadFront>& roads,
                                           const RoadShift& rule) {
    const std::vector<Edge> edges = edgesOf(parcel.outer, roads, rule);
    std::vector<Footprint> pieces{parcel};
    for (std::size_t i = 0; i < edges.size(); ++i) {
        const Edge &edge = edges[i], &before = edges[(i + edges.size() - 1) % edges.size()];
        if (edge.shiftM <= 0) continue;
        const glm::dvec2 out = edge.outward * edge.shiftM;
        pieces.push_back(polygonOf({edge.from, edge.from + out, edge.to + out, edge.to}));
        if (before.shiftM > 0 && pointsOutwards(before, edge)) pieces.push_back(cornerOf(before, edge));
    }
    if (pieces.size() == 1) return pieces;
    const Geos geos;
    const Geos::Geometry all = uniteGeometry(geos, collection(geos, pieces));
    if (!all) return failure("The line along the roads cannot be made", "parcel", "Draw the parcel again");
    return toPolygons(geos, all);
}

}  // namespace noonmark
