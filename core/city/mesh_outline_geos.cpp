#include "core/city/mesh_outline.h"

#include <geos_c.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <memory>
#include <numeric>

#include "core/city/geos_shapes.h"
#include "core/city/mesh_topology.h"
#include "core/city/plan_overlay.h"

namespace noonmark {

namespace {

using Geometry = Geos::Geometry;

// The triangles that matter from above, as flat polygons.
std::vector<Footprint> projectedTriangles(const TriangleMesh& mesh, bool onlyUpward) {
    constexpr double leastTriangleM2 = 1e-6;
    std::vector<Footprint> triangles;
    for (const glm::uvec3 t : mesh.triangles) {
        Ring ring{glm::vec2(mesh.vertices[t.x]), glm::vec2(mesh.vertices[t.y]),
                  glm::vec2(mesh.vertices[t.z])};
        const double area = signedArea(ring);
        if (area < (onlyUpward ? leastTriangleM2 : -1e30) || std::abs(area) < leastTriangleM2) continue;
        triangles.push_back({std::move(ring), {}});
    }
    return triangles;
}

std::vector<Footprint> convexHullOf(const Geos& geos, const TriangleMesh& mesh) {
    std::vector<GEOSGeometry*> points;
    for (const glm::uvec3 t : mesh.triangles)
        for (int i = 0; i < 3; ++i) {
            const glm::vec3 point = mesh.vertices[t[i]];
            points.push_back(GEOSGeom_createPointFromXY_r(geos, double(point.x), double(point.y)));
        }
    const auto cloud = geos.owned(
        GEOSGeom_createCollection_r(geos, GEOS_MULTIPOINT, points.data(), unsigned(points.size())));
    return polygonsOf(geos, geos.owned(cloud ? GEOSConvexHull_r(geos, cloud.get()) : nullptr));
}

Box2 boundsOf(const std::vector<Footprint>& outline) {
    Box2 box;
    for (const Footprint& footprint : outline) box.add(bounds(footprint));
    return box;
}

bool overlap(const Box2& a, const Box2& b) {
    return a.low.x < b.high.x && b.low.x < a.high.x && a.low.y < b.high.y && b.low.y < a.high.y;
}

std::size_t rootOf(std::vector<std::size_t>& parent, std::size_t i) {
    while (parent[i] != i) i = parent[i] = parent[parent[i]];
    return i;
}

std::vector<std::size_t> westToEast(const std::vector<Box2>& boxes) {
    std::vector<std::size_t> order(boxes.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::sort(order.begin(), order.end(), [&](auto a, auto b) { return boxes[a].low.x < boxes[b].low.x; });
    return order;
}

std::vector<std::size_t> numberedByAppearance(std::vector<std::size_t>& parent) {
    constexpr std::size_t unknown = ~std::size_t(0);
    std::vector<std::size_t> numberOfRoot(parent.size(), unknown);
    std::vector<std::size_t> groups;
    std::size_t count = 0;
    for (std::size_t i = 0; i < parent.size(); ++i) {
        std::size_t& number = numberOfRoot[rootOf(parent, i)];
        if (number == unknown) number = count++;
        groups.push_back(number);
    }
    return groups;
}

// Grown and shrunk again, corners kept: closes gaps of up to twice `widthM`, as between triangles that nearly
// meet.
Geometry withoutGaps(const Geos& geos, Geometry polygons, double widthM) {
    constexpr int segments = 8;
    constexpr double mitre = 5;
    for (const double width : {widthM, -widthM})
        if (polygons)
            polygons = geos.owned(GEOSBufferWithStyle_r(geos, polygons.get(), width, segments,
                                                        GEOSBUF_CAP_FLAT, GEOSBUF_JOIN_MITRE, mitre));
    return polygons;
}

// In one piece if it can be.
std::vector<Footprint> unionOfTriangles(const Geos& geos, const std::vector<Footprint>& triangles) {
    constexpr double gapM = 0.005;
    Geometry joined = unionGeometry(geos, collection(geos, triangles));
    if (joined && GEOSGetNumGeometries_r(geos, joined.get()) > 1)
        joined = unionGeometry(geos, withoutGaps(geos, std::move(joined), gapM));
    return polygonsOf(geos, joined);
}

}  // namespace

MeshOutline outlineOf(const TriangleMesh& mesh, bool closed) {
    const Geos geos;
    MeshOutline outline;
    outline.pieces = unionOfTriangles(geos, projectedTriangles(mesh, closed));
    if (!outline.pieces.empty() || mesh.triangles.empty()) return outline;
    outline.pieces = convexHullOf(geos, mesh);
    outline.convexHull = true;
    return outline;
}

std::vector<Footprint> unionOf(const std::vector<Footprint>& footprints) {
    const Geos geos;
    return polygonsOf(geos, unionGeometry(geos, collection(geos, footprints)));
}

double areaOutside(const Footprint& footprint, const std::vector<Footprint>& others) {
    const Geos geos;
    const Geometry whole = collection(geos, std::vector<Footprint>{footprint});
    const Geometry cover = unionGeometry(geos, collection(geos, others));
    const Geometry rest = differenceGeometry(geos, whole, cover);
    return rest ? areaOf(geos, rest) : area(footprint);
}

std::vector<std::size_t> overlapGroups(const std::vector<std::vector<Footprint>>& outlines) {
    std::vector<Box2> boxes;
    for (const auto& outline : outlines) boxes.push_back(boundsOf(outline));
    std::vector<std::size_t> parent(outlines.size());
    std::iota(parent.begin(), parent.end(), std::size_t(0));
    const std::vector<std::size_t> order = westToEast(boxes);
    for (std::size_t i = 0; i < order.size(); ++i)
        for (std::size_t j = i + 1; j < order.size() && boxes[order[j]].low.x < boxes[order[i]].high.x; ++j) {
            const std::size_t a = rootOf(parent, order[i]);
            const std::size_t b = rootOf(parent, order[j]);
            if (a == b || !overlap(boxes[order[i]], boxes[order[j]])) continue;
            if (sharedArea(outlines[order[i]], outlines[order[j]]) > sliverAreaM2) parent[b] = a;
        }
    return numberedByAppearance(parent);
}

}  // namespace noonmark
