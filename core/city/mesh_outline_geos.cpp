#include "core/city/mesh_outline.h"

#include <geos_c.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <memory>
#include <numeric>

#include "core/city/mesh_topology.h"

namespace noonmark {

namespace {

constexpr double gridM = 0.001;
constexpr double leastAreaM2 = 0.01;

// A GEOS context that says nothing; failures are null pointers.
class Geos {
public:
    Geos() : context_(GEOS_init_r()) {}
    Geos(const Geos&) = delete;
    Geos& operator=(const Geos&) = delete;
    ~Geos() { GEOS_finish_r(context_); }
    operator GEOSContextHandle_t() const { return context_; }

    struct Destroy {
        GEOSContextHandle_t context;
        void operator()(GEOSGeometry* geometry) const { GEOSGeom_destroy_r(context, geometry); }
    };
    using Geometry = std::unique_ptr<GEOSGeometry, Destroy>;
    [[nodiscard]] Geometry owned(GEOSGeometry* geometry) const { return {geometry, Destroy{context_}}; }

private:
    GEOSContextHandle_t context_;
};
using Geometry = Geos::Geometry;

GEOSGeometry* ringGeometry(const Geos& geos, const Ring& ring) {
    GEOSCoordSequence* points = GEOSCoordSeq_create_r(geos, unsigned(ring.size() + 1), 2);
    for (std::size_t i = 0; i <= ring.size(); ++i) {
        const glm::vec2 point = ring[i % ring.size()];
        GEOSCoordSeq_setXY_r(geos, points, unsigned(i), double(point.x), double(point.y));
    }
    return GEOSGeom_createLinearRing_r(geos, points);
}

GEOSGeometry* polygonGeometry(const Geos& geos, const Footprint& footprint) {
    std::vector<GEOSGeometry*> holes;
    for (const Ring& hole : footprint.holes) holes.push_back(ringGeometry(geos, hole));
    return GEOSGeom_createPolygon_r(geos, ringGeometry(geos, footprint.outer), holes.data(),
                                    unsigned(holes.size()));
}

Geometry collection(const Geos& geos, std::vector<GEOSGeometry*> polygons) {
    return geos.owned(
        GEOSGeom_createCollection_r(geos, GEOS_MULTIPOLYGON, polygons.data(), unsigned(polygons.size())));
}

Geometry collection(const Geos& geos, const std::vector<Footprint>& footprints) {
    std::vector<GEOSGeometry*> polygons;
    for (const Footprint& footprint : footprints) polygons.push_back(polygonGeometry(geos, footprint));
    return collection(geos, std::move(polygons));
}

// Without points on straight lines, which a union of triangles is full of.
Geometry unionGeometry(const Geos& geos, const Geometry& polygons) {
    if (!polygons) return geos.owned(nullptr);
    const Geometry joined = geos.owned(GEOSUnaryUnionPrec_r(geos, polygons.get(), gridM));
    if (!joined) return geos.owned(nullptr);
    return geos.owned(GEOSTopologyPreserveSimplify_r(geos, joined.get(), gridM));
}

// Points that fall together in float32 are one; the way it runs is put right.
Ring ringOf(const Geos& geos, const GEOSGeometry* geometry, bool counterClockwise) {
    const GEOSCoordSequence* points = GEOSGeom_getCoordSeq_r(geos, geometry);
    unsigned count = 0;
    GEOSCoordSeq_getSize_r(geos, points, &count);
    Ring ring;
    for (unsigned i = 0; i + 1 < count; ++i) {
        glm::dvec2 point{};
        GEOSCoordSeq_getXY_r(geos, points, i, &point.x, &point.y);
        if (ring.empty() || ring.back() != glm::vec2(point)) ring.emplace_back(point);
    }
    while (ring.size() > 1 && ring.front() == ring.back()) ring.pop_back();
    if ((signedArea(ring) > 0) != counterClockwise) std::reverse(ring.begin(), ring.end());
    return ring;
}

bool isSliver(const Ring& ring) { return ring.size() < 3 || std::abs(signedArea(ring)) < leastAreaM2; }

void collectPolygons(const Geos& geos, const GEOSGeometry* geometry, std::vector<Footprint>& footprints) {
    if (geometry == nullptr) return;
    if (GEOSGeomTypeId_r(geos, geometry) != GEOS_POLYGON) {
        const int count =
            GEOSGeomTypeId_r(geos, geometry) >= GEOS_MULTIPOINT ? GEOSGetNumGeometries_r(geos, geometry) : 0;
        for (int i = 0; i < count; ++i)
            collectPolygons(geos, GEOSGetGeometryN_r(geos, geometry, i), footprints);
        return;
    }
    if (GEOSisEmpty_r(geos, geometry) != 0) return;
    Footprint footprint{ringOf(geos, GEOSGetExteriorRing_r(geos, geometry), true), {}};
    if (isSliver(footprint.outer)) return;
    for (int i = 0; i < GEOSGetNumInteriorRings_r(geos, geometry); ++i) {
        Ring hole = ringOf(geos, GEOSGetInteriorRingN_r(geos, geometry, i), false);
        if (!isSliver(hole)) footprint.holes.push_back(std::move(hole));
    }
    footprints.push_back(std::move(footprint));
}

std::vector<Footprint> polygonsOf(const Geos& geos, const Geometry& geometry) {
    std::vector<Footprint> footprints;
    collectPolygons(geos, geometry.get(), footprints);
    return footprints;
}

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

double areaOf(const Geos& geos, const Geometry& geometry) {
    double area = 0;
    if (geometry) GEOSArea_r(geos, geometry.get(), &area);
    return area;
}

double sharedArea(const std::vector<Footprint>& a, const std::vector<Footprint>& b) {
    const Geos geos;
    const Geometry first = collection(geos, a);
    const Geometry second = collection(geos, b);
    if (!first || !second) return 0;
    return areaOf(geos, geos.owned(GEOSIntersectionPrec_r(geos, first.get(), second.get(), gridM)));
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

}  // namespace

MeshOutline outlineOf(const TriangleMesh& mesh, bool closed) {
    const Geos geos;
    MeshOutline outline;
    outline.pieces =
        polygonsOf(geos, unionGeometry(geos, collection(geos, projectedTriangles(mesh, closed))));
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
    if (!whole || !cover) return area(footprint);
    const Geometry rest = geos.owned(GEOSDifferencePrec_r(geos, whole.get(), cover.get(), gridM));
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
            if (sharedArea(outlines[order[i]], outlines[order[j]]) > leastAreaM2) parent[b] = a;
        }
    return numberedByAppearance(parent);
}

}  // namespace noonmark
