#include "core/city/meshes/mesh_outline.h"

#include <geos_c.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <iterator>
#include <memory>
#include <numeric>
#include <set>

#include "core/base/disjoint_sets.h"
#include "core/base/stop_scope.h"
#include "core/city/footprints/geos_shapes.h"
#include "core/city/footprints/plan_overlay.h"
#include "core/city/meshes/mesh_topology.h"

namespace noonmark {

namespace {

using Geometry = Geos::Geometry;

// Of large meshes: triangles that come again add nothing to a union, but GEOS would take minutes for a
// million.
class RepeatedTriangles {
public:
    explicit RepeatedTriangles(std::size_t triangles) : isLarge_(triangles > 10'000) {}
    bool holds(const Ring& ring) {
        return isLarge_ &&
               !known_.insert({ring[0].x, ring[0].y, ring[1].x, ring[1].y, ring[2].x, ring[2].y}).second;
    }

private:
    bool isLarge_;
    std::set<std::array<float, 6>> known_;
};

// The projections of the relevant triangles, as polygons in plan.
std::vector<Footprint> projectedTriangles(const TriangleMesh& mesh, bool onlyUpward) {
    constexpr double minTriangleM2 = 1e-6;
    std::vector<Footprint> triangles;
    RepeatedTriangles repeated(mesh.triangles.size());
    for (const glm::uvec3 t : mesh.triangles) {
        if (StopScope::isStopped()) return {};
        Ring ring{glm::vec2(mesh.vertices[t.x]), glm::vec2(mesh.vertices[t.y]),
                  glm::vec2(mesh.vertices[t.z])};
        const double area = signedArea(ring);
        if (area < (onlyUpward ? minTriangleM2 : -1e30) || std::abs(area) < minTriangleM2) continue;
        if (repeated.holds(ring)) continue;
        triangles.push_back({std::move(ring), {}});
    }
    return triangles;
}

// A vertical face seen from above.
struct WallTrace {
    glm::dvec2 a, b;
    float lowM;  // height of the face's lowest point
};

std::vector<WallTrace> wallTraces(const TriangleMesh& mesh) {
    constexpr double plumbLean = 0.0175;
    std::vector<WallTrace> traces;
    for (const glm::uvec3 t : mesh.triangles) {
        const glm::dvec3 p[] = {glm::dvec3(mesh.vertices[t.x]), glm::dvec3(mesh.vertices[t.y]),
                                glm::dvec3(mesh.vertices[t.z])};
        const glm::dvec3 doubled = glm::cross(p[1] - p[0], p[2] - p[0]);
        if (std::abs(doubled.z) > plumbLean * glm::length(doubled)) continue;
        WallTrace longest{glm::dvec2(p[0]), glm::dvec2(p[0]), float(std::min({p[0].z, p[1].z, p[2].z}))};
        for (int i = 0; i < 3; ++i) {
            const glm::dvec2 a(p[i]), b(p[(i + 1) % 3]);
            if (glm::distance(a, b) > glm::distance(longest.a, longest.b)) longest.a = a, longest.b = b;
        }
        if (longest.a != longest.b) traces.push_back(longest);
    }
    return traces;
}

std::vector<WallTrace> lowWallTraces(const TriangleMesh& mesh, float aboveM) {
    std::vector<WallTrace> traces = wallTraces(mesh);
    const float highestFoot = computeBox(mesh).low.z + aboveM;
    std::erase_if(traces, [&](const WallTrace& trace) { return trace.lowM > highestFoot; });
    return traces;
}

// Each line once: equal walls above one another are one in plan.
std::vector<PlanLine> linesOf(const std::vector<WallTrace>& traces) {
    std::vector<PlanLine> lines;
    std::set<std::array<double, 4>> known;
    for (const WallTrace& trace : traces)
        if (known.insert({trace.a.x, trace.a.y, trace.b.x, trace.b.y}).second)
            lines.push_back({trace.a, trace.b});
    return lines;
}

// Strips with a smaller area would be dropped as slivers when they are moved or read again.
constexpr double minStripM2 = 2 * sliverAreaM2;

// A thin rectangle along a line.
Footprint stripAlong(glm::dvec2 a, glm::dvec2 b) {
    const double lengthM = std::max(1e-3, glm::distance(a, b));
    const double widthM = std::max(wallStripM, minStripM2 / lengthM);
    const glm::dvec2 along = (b - a) / lengthM, end = along * (wallStripM / 2);
    const glm::dvec2 side = glm::dvec2(-along.y, along.x) * (widthM / 2);
    return {{glm::vec2(a - end - side), glm::vec2(b + end - side), glm::vec2(b + end + side),
             glm::vec2(a - end + side)},
            {}};
}

WallTrace farthestApart(const std::vector<WallTrace>& traces) {
    WallTrace far = traces.front();
    for (const WallTrace& trace : traces)
        for (const glm::dvec2 end : {trace.a, trace.b})
            if (glm::distance(traces.front().a, end) > glm::distance(far.a, far.b))
                far = {traces.front().a, end, 0};
    return far;
}

std::vector<Footprint> wallStrips(const Geos& geos, const std::vector<WallTrace>& traces) {
    constexpr int segments = 1;
    constexpr double mitre = 2;
    const Geometry lines = nodeLines(geos, linesOf(traces));
    const Geometry strips =
        geos.owned(lines ? GEOSBufferWithStyle_r(geos, lines.get(), wallStripM / 2, segments,
                                                 GEOSBUF_CAP_SQUARE, GEOSBUF_JOIN_MITRE, mitre)
                         : nullptr);
    return toPolygons(geos, strips);
}

// Walls that are too short for GEOS's pieces become a rectangle.
std::vector<Footprint> stripsOrRectangle(const Geos& geos, const std::vector<WallTrace>& traces) {
    if (traces.empty()) return {};
    std::vector<Footprint> strips = wallStrips(geos, traces);
    if (strips.size() > 1 || (strips.size() == 1 && area(strips[0]) >= minStripM2)) return strips;
    const WallTrace far = farthestApart(traces);
    return {stripAlong(far.a, far.b)};
}

bool holds(const Box2& box, glm::dvec2 point, float marginM) {
    return float(point.x) >= box.low.x - marginM && float(point.x) <= box.high.x + marginM &&
           float(point.y) >= box.low.y - marginM && float(point.y) <= box.high.y + marginM;
}

// The outline must bound the mesh: engines look for occluders only inside it.
std::vector<Footprint> withWallsOutside(const Geos& geos, const TriangleMesh& mesh,
                                        std::vector<Footprint> pieces) {
    constexpr float marginM = float(wallStripM);
    Box2 box;
    for (const Footprint& piece : pieces) box.add(bounds(piece));
    std::vector<WallTrace> outside = wallTraces(mesh);
    std::erase_if(outside, [&](const WallTrace& trace) {
        return holds(box, trace.a, marginM) && holds(box, trace.b, marginM);
    });
    if (outside.empty()) return pieces;
    std::ranges::move(stripsOrRectangle(geos, outside), std::back_inserter(pieces));
    return toPolygons(geos, uniteGeometry(geos, collection(geos, pieces)));
}

Box2 boundsOf(const std::vector<Footprint>& outline) {
    Box2 box;
    for (const Footprint& footprint : outline) box.add(bounds(footprint));
    return box;
}

bool overlap(const Box2& a, const Box2& b) {
    return a.low.x < b.high.x && b.low.x < a.high.x && a.low.y < b.high.y && b.low.y < a.high.y;
}

std::vector<std::size_t> westToEast(const std::vector<Box2>& boxes) {
    std::vector<std::size_t> order(boxes.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::sort(order.begin(), order.end(), [&](auto a, auto b) { return boxes[a].low.x < boxes[b].low.x; });
    return order;
}

// Buffers outward and inward again with mitred corners: closes gaps of up to twice `widthM`, as between
// triangles that nearly meet.
Geometry withoutGaps(const Geos& geos, Geometry polygons, double widthM) {
    constexpr int segments = 8;
    constexpr double mitre = 5;
    for (const double width : {widthM, -widthM})
        if (polygons)
            polygons = geos.owned(GEOSBufferWithStyle_r(geos, polygons.get(), width, segments,
                                                        GEOSBUF_CAP_FLAT, GEOSBUF_JOIN_MITRE, mitre));
    return polygons;
}

// The sections, and the triangles that reach beyond them.
std::vector<Footprint> keepUncovered(const Geos& geos, std::vector<Footprint> triangles,
                                     const std::vector<Footprint>& sections) {
    const Geometry cover = uniteGeometry(geos, collection(geos, sections));
    const GEOSPreparedGeometry* prepared = cover ? GEOSPrepare_r(geos, cover.get()) : nullptr;
    if (!prepared) return triangles;
    std::erase_if(triangles, [&](const Footprint& triangle) {
        const Geometry shape = collection(geos, std::vector<Footprint>{triangle});
        return shape && GEOSPreparedCovers_r(geos, prepared, shape.get()) == 1;
    });
    GEOSPreparedGeom_destroy_r(geos, prepared);
    triangles.insert(triangles.end(), sections.begin(), sections.end());
    return triangles;
}

// The union of triangles that meet edge to edge, as the roof of a closed mesh does: by cancelling shared
// edges, which is several times faster than an overlay. Null where they overlap: the area then differs from
// the sum, since what lies under an even number of triangles is missing.
Geometry joinEdgeToEdge(const Geos& geos, const std::vector<Footprint>& triangles) {
    constexpr double tolerance = 1e-9;
    const double sum = area(triangles);
    const Geometry all = collection(geos, triangles);
    const Geometry joined = geos.owned(all ? GEOSCoverageUnion_r(geos, all.get()) : nullptr);
    if (std::abs(computeArea(geos, joined) - sum) > tolerance * sum) return geos.owned(nullptr);
    if (!joined || GEOSisValid_r(geos, joined.get()) != 1) return geos.owned(nullptr);
    return geos.owned(GEOSTopologyPreserveSimplify_r(geos, joined.get(), overlayGridM));
}

Geometry joinTriangles(const Geos& geos, const std::vector<Footprint>& triangles) {
    Geometry joined = joinEdgeToEdge(geos, triangles);
    return joined ? std::move(joined) : uniteGeometry(geos, collection(geos, triangles));
}

// In one piece if possible.
std::vector<Footprint> unionOfTriangles(const Geos& geos, const std::vector<Footprint>& triangles) {
    constexpr double gapM = 0.005;
    Geometry joined = joinTriangles(geos, triangles);
    if (joined && GEOSGetNumGeometries_r(geos, joined.get()) > 1)
        joined = uniteGeometry(geos, withoutGaps(geos, std::move(joined), gapM));
    return toPolygons(geos, joined);
}

}  // namespace

MeshOutline computeOutline(const TriangleMesh& mesh, bool closed, const std::vector<Footprint>& sections) {
    const Geos geos;
    MeshOutline outline;
    std::vector<Footprint> triangles = projectedTriangles(mesh, closed);
    if (!sections.empty()) triangles = keepUncovered(geos, std::move(triangles), sections);
    outline.pieces = unionOfTriangles(geos, triangles);
    if (mesh.triangles.empty()) return outline;
    if (!outline.pieces.empty()) {
        if (!closed) outline.pieces = withWallsOutside(geos, mesh, std::move(outline.pieces));
        return outline;
    }
    outline.wallsOnly = true;
    outline.pieces = findEnclosedFaces(linesOf(wallTraces(mesh)));
    outline.pieces = outline.pieces.empty() ? stripsOrRectangle(geos, wallTraces(mesh))
                                            : withWallsOutside(geos, mesh, std::move(outline.pieces));
    return outline;
}

std::vector<Footprint> findEnclosedByWalls(const TriangleMesh& mesh, float aboveM) {
    return findEnclosedFaces(linesOf(lowWallTraces(mesh, aboveM)));
}

double computeWalledShare(const TriangleMesh& mesh, const Footprint& outline, float aboveM) {
    constexpr double besideM = 1;
    const Geos geos;
    const Geometry lines = nodeLines(geos, linesOf(lowWallTraces(mesh, aboveM)));
    const Geometry whole = collection(geos, std::vector<Footprint>{outline});
    const Geometry around = geos.owned(whole ? GEOSBuffer_r(geos, whole.get(), besideM, 4) : nullptr);
    if (!lines || !around) return 0;
    const Geometry under = geos.owned(GEOSIntersection_r(geos, lines.get(), around.get()));
    double walled = 0, length = 0;
    if (under) GEOSLength_r(geos, under.get(), &walled);
    GEOSLength_r(geos, whole.get(), &length);
    return std::min(1.0, walled / std::max(1e-9, length));
}

std::vector<Footprint> computeUnion(const std::vector<Footprint>& footprints) {
    const Geos geos;
    return toPolygons(geos, uniteGeometry(geos, collection(geos, footprints)));
}

double computeAreaOutside(const Footprint& footprint, const std::vector<Footprint>& others) {
    const Geos geos;
    const Geometry whole = collection(geos, std::vector<Footprint>{footprint});
    const Geometry cover = uniteGeometry(geos, collection(geos, others));
    const Geometry rest = subtractGeometry(geos, whole, cover);
    return rest ? computeArea(geos, rest) : area(footprint);
}

std::vector<std::size_t> groupOverlapping(const std::vector<std::vector<Footprint>>& outlines) {
    std::vector<Box2> boxes;
    for (const auto& outline : outlines) boxes.push_back(boundsOf(outline));
    DisjointSets groups(outlines.size());
    const std::vector<std::size_t> order = westToEast(boxes);
    for (std::size_t i = 0; i < order.size(); ++i)
        for (std::size_t j = i + 1; j < order.size() && boxes[order[j]].low.x < boxes[order[i]].high.x; ++j) {
            if (groups.of(order[i]) == groups.of(order[j]) || !overlap(boxes[order[i]], boxes[order[j]]))
                continue;
            if (computeSharedArea(outlines[order[i]], outlines[order[j]]) > sliverAreaM2)
                groups.join(order[i], order[j]);
        }
    return groups.number();
}

}  // namespace noonmark
