#include "core/receivers/parcels/parcel_lines.h"

#include <geos_c.h>
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>

#include "core/city/footprints/geos_shapes.h"

namespace noonmark {

namespace {

constexpr int chordsPerQuarter = 16;

}  // namespace

Result<std::vector<Footprint>> cutBelt(const std::vector<Footprint>& polygons, double innerM, double outerM) {
    const Geos geos;
    const Geos::Geometry all = uniteGeometry(geos, collection(geos, polygons));
    if (!all) return failure("The polygons cannot be joined", "parcel", "Draw the parcel again");
    const auto grown = [&](double byM) {
        return geos.owned(GEOSBuffer_r(geos, all.get(), byM, chordsPerQuarter));
    };
    const Geos::Geometry belt = subtractGeometry(geos, grown(outerM), grown(innerM));
    if (!belt)
        return failure("The lines around the polygons cannot be made", "parcel", "Draw the parcel again");
    return toPolygons(geos, belt);
}

Result<std::vector<Ring>> drawLines(const std::vector<Footprint>& polygons, double offsetM) {
    const Geos geos;
    const Geos::Geometry all = uniteGeometry(geos, collection(geos, polygons));
    if (!all) return failure("The polygons cannot be joined", "parcel", "Draw the parcel again");
    const Geos::Geometry grown = geos.owned(GEOSBuffer_r(geos, all.get(), offsetM, chordsPerQuarter));
    if (!grown)
        return failure("The lines around the polygons cannot be made", "parcel", "Draw the parcel again");
    std::vector<Ring> rings;
    for (const Footprint& polygon : toPolygons(geos, grown)) {
        rings.push_back(polygon.outer);
        rings.insert(rings.end(), polygon.holes.begin(), polygon.holes.end());
    }
    return rings;
}

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

/// The shift of the nearest front; of fronts that are equally near the smallest.
double shiftAlong(glm::dvec2 outward, const std::vector<RoadFront>& roads, const RoadShift& rule) {
    constexpr double widestDeg = 45, equalDeg = 0.1;
    double nearest = widestDeg;
    for (const RoadFront& road : roads) nearest = std::min(nearest, awayFrom(road.side, outward));
    double minimum = std::numeric_limits<double>::infinity();
    for (const RoadFront& road : roads)
        if (awayFrom(road.side, outward) <= nearest + equalDeg)
            minimum = std::min(minimum, shiftOf(rule, road.widthM));
    return std::isinf(minimum) ? 0 : minimum;
}

/// Whether an edge lies on the parcel's convex hull, or hardly behind it.
class Outermost {
public:
    explicit Outermost(const Footprint& parcel) : border_(geos_.owned(nullptr)) {
        const auto polygon = collection(geos_, {parcel});
        const auto hull = geos_.owned(polygon ? GEOSConvexHull_r(geos_, polygon.get()) : nullptr);
        if (hull) border_ = geos_.owned(GEOSBoundary_r(geos_, hull.get()));
    }

    [[nodiscard]] bool operator()(glm::dvec2 from, glm::dvec2 to) const {
        return isOnHull(from) && isOnHull(to);
    }

private:
    [[nodiscard]] bool isOnHull(glm::dvec2 point) const {
        constexpr double nearM = 1;
        const auto at = geos_.owned(GEOSGeom_createPointFromXY_r(geos_, point.x, point.y));
        double distanceM = 0;
        return at && border_ && GEOSDistance_r(geos_, at.get(), border_.get(), &distanceM) == 1 &&
               distanceM <= nearM;
    }

    Geos geos_;
    Geos::Geometry border_;  // null if GEOS fails: then no edge lies along a road, which the result says
};

std::vector<Edge> edgesOf(const Footprint& parcel, const std::vector<RoadFront>& roads,
                          const RoadShift& rule) {
    const Outermost isOutermost(parcel);
    const Ring& ring = parcel.outer;
    std::vector<Edge> edges;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const glm::dvec2 from(ring[i]), to(ring[(i + 1) % ring.size()]);
        if (from == to) continue;
        const glm::dvec2 along = glm::normalize(to - from);
        const glm::dvec2 outward(along.y, -along.x);  // the ring runs counter-clockwise
        edges.push_back({from, to, outward, isOutermost(from, to) ? shiftAlong(outward, roads, rule) : 0});
    }
    return edges;
}

Footprint polygonOf(std::initializer_list<glm::dvec2> points) {
    Footprint polygon;
    for (const glm::dvec2 point : points) polygon.outer.emplace_back(point);
    return polygon;
}

/// The ground between two strips at a corner that points outwards. Very sharp corners are cut. Where the line
/// of the narrower strip meets the square end of the wider one, it ends there.
Footprint cornerOf(const Edge& before, const Edge& after) {
    constexpr double longestMiter = 4;  // in shifts
    const glm::dvec2 corner = after.from;
    const glm::dvec2 a = corner + before.outward * before.shiftM, b = corner + after.outward * after.shiftM;
    const double cosine = glm::dot(before.outward, after.outward);
    if (after.shiftM < before.shiftM * cosine)
        return polygonOf({corner, corner + before.outward * (after.shiftM / cosine), b});
    if (before.shiftM < after.shiftM * cosine)
        return polygonOf({corner, a, corner + after.outward * (before.shiftM / cosine)});
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
    const std::vector<Edge> edges = edgesOf(parcel, roads, rule);
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
