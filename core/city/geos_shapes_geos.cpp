#include <geos_c.h>

#include <algorithm>
#include <cmath>

#include "core/city/geos_shapes.h"

namespace noonmark {

Geos::Geos() : context_(GEOS_init_r()) {}
Geos::~Geos() { GEOS_finish_r(context_); }
void Geos::Destroy::operator()(GEOSGeometry* geometry) const { GEOSGeom_destroy_r(context, geometry); }

namespace {

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

bool isSliver(const Ring& ring) { return ring.size() < 3 || std::abs(signedArea(ring)) < sliverAreaM2; }

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

}  // namespace

Geos::Geometry collection(const Geos& geos, std::vector<GEOSGeometry*> polygons) {
    return geos.owned(
        GEOSGeom_createCollection_r(geos, GEOS_MULTIPOLYGON, polygons.data(), unsigned(polygons.size())));
}

Geos::Geometry collection(const Geos& geos, const std::vector<Footprint>& footprints) {
    std::vector<GEOSGeometry*> polygons;
    for (const Footprint& footprint : footprints) polygons.push_back(polygonGeometry(geos, footprint));
    return collection(geos, std::move(polygons));
}

// In full precision first: snapping to a grid takes several times as long, and in GEOS 3.11 may move a corner
// that two polygons share for one of them only.
Geos::Geometry unionGeometry(const Geos& geos, const Geos::Geometry& polygons) {
    if (!polygons) return geos.owned(nullptr);
    Geos::Geometry joined = geos.owned(GEOSUnaryUnion_r(geos, polygons.get()));
    if (!joined) joined = geos.owned(GEOSUnaryUnionPrec_r(geos, polygons.get(), overlayGridM));
    if (!joined) return joined;
    return geos.owned(GEOSTopologyPreserveSimplify_r(geos, joined.get(), overlayGridM));
}

Geos::Geometry differenceGeometry(const Geos& geos, const Geos::Geometry& whole,
                                  const Geos::Geometry& cover) {
    if (!whole || !cover) return geos.owned(nullptr);
    Geos::Geometry rest = geos.owned(GEOSDifference_r(geos, whole.get(), cover.get()));
    return rest ? std::move(rest)
                : geos.owned(GEOSDifferencePrec_r(geos, whole.get(), cover.get(), overlayGridM));
}

std::vector<Footprint> polygonsOf(const Geos& geos, const Geos::Geometry& geometry) {
    std::vector<Footprint> footprints;
    collectPolygons(geos, geometry.get(), footprints);
    return footprints;
}

double areaOf(const Geos& geos, const Geos::Geometry& geometry) {
    double area = 0;
    if (geometry) GEOSArea_r(geos, geometry.get(), &area);
    return area;
}

}  // namespace noonmark
