#include <geos_c.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <stdexcept>

#include "core/base/stop_scope.h"
#include "core/city/footprints/geos_shapes.h"

namespace noonmark {

namespace {

struct GeosStopped : std::runtime_error {
    GeosStopped() : std::runtime_error("stopped") {}
};

// GEOS calls this in its long loops. Its own way to interrupt is a flag of the whole process, which another
// thread could answer; an exception ends the operation of this thread, and GEOS returns a null pointer.
void throwIfStopped() {
    if (StopScope::isStopped()) throw GeosStopped();
}

GEOSContextHandle_t makeContext() {
    static const auto before = GEOS_interruptRegisterCallback(throwIfStopped);
    (void)before;
    return GEOS_init_r();
}

}  // namespace

Geos::Geos() : context_(makeContext()) {}
Geos::~Geos() { GEOS_finish_r(context_); }
void Geos::Destroy::operator()(GEOSGeometry* geometry) const { GEOSGeom_destroy_r(context, geometry); }

namespace {

GEOSGeometry* ringGeometry(const Geos& geos, const auto& ring) {
    GEOSCoordSequence* points = GEOSCoordSeq_create_r(geos, unsigned(ring.size() + 1), 2);
    for (std::size_t i = 0; i <= ring.size(); ++i) {
        const auto point = ring[i % ring.size()];
        GEOSCoordSeq_setXY_r(geos, points, unsigned(i), double(point.x), double(point.y));
    }
    return GEOSGeom_createLinearRing_r(geos, points);
}

template <class Points>
GEOSGeometry* polygonFrom(const Geos& geos, const Points& outer, std::span<const Points> inner) {
    std::vector<GEOSGeometry*> holes;
    for (const auto& hole : inner) holes.push_back(ringGeometry(geos, hole));
    return GEOSGeom_createPolygon_r(geos, ringGeometry(geos, outer), holes.data(), unsigned(holes.size()));
}

// Merges points that coincide in float32, and corrects the orientation.
Ring parseRing(const Geos& geos, const GEOSGeometry* geometry, bool counterClockwise) {
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

/// Collects the polygons of a geometry.
class PolygonCollector {
public:
    PolygonCollector(const Geos& geos, double minM2) : geos_(geos), minM2_(minM2) {}

    void collect(const GEOSGeometry* geometry) {
        if (geometry == nullptr) return;
        if (GEOSGeomTypeId_r(geos_, geometry) == GEOS_POLYGON) return add(geometry);
        if (GEOSGeomTypeId_r(geos_, geometry) < GEOS_MULTIPOINT) return;  // points and lines have no interior
        for (int i = 0; i < GEOSGetNumGeometries_r(geos_, geometry); ++i)
            collect(GEOSGetGeometryN_r(geos_, geometry, i));
    }

    std::vector<Footprint> footprints;
    bool sliver = false;  ///< a polygon or hole was dropped since it was too small

private:
    void add(const GEOSGeometry* polygon) {
        if (GEOSisEmpty_r(geos_, polygon) != 0) return;
        Footprint footprint{parseRing(geos_, GEOSGetExteriorRing_r(geos_, polygon), true), {}};
        for (int i = 0; i < GEOSGetNumInteriorRings_r(geos_, polygon); ++i) {
            Ring hole = parseRing(geos_, GEOSGetInteriorRingN_r(geos_, polygon, i), false);
            if (!left(hole)) footprint.holes.push_back(std::move(hole));
        }
        if (!left(footprint.outer)) footprints.push_back(std::move(footprint));
    }

    bool left(const Ring& ring) {
        const bool small = ring.size() < 3 || std::abs(signedArea(ring)) < minM2_;
        sliver = sliver || small;
        return small;
    }

    const Geos& geos_;
    double minM2_;
};

}  // namespace

Geos::Geometry makePolygonGeometry(const Geos& geos, const std::vector<RawRing>& rings) {
    return geos.owned(polygonFrom(geos, rings.front(), std::span<const RawRing>(rings).subspan(1)));
}

Geos::Geometry collection(const Geos& geos, std::vector<GEOSGeometry*> polygons) {
    return geos.owned(
        GEOSGeom_createCollection_r(geos, GEOS_MULTIPOLYGON, polygons.data(), unsigned(polygons.size())));
}

Geos::Geometry collection(const Geos& geos, const std::vector<Footprint>& footprints) {
    std::vector<GEOSGeometry*> polygons;
    for (const Footprint& footprint : footprints)
        polygons.push_back(polygonFrom(geos, footprint.outer, std::span<const Ring>(footprint.holes)));
    return collection(geos, std::move(polygons));
}

Geos::Geometry nodeLines(const Geos& geos, const std::vector<PlanLine>& lines) {
    if (lines.empty()) return geos.owned(nullptr);
    std::vector<GEOSGeometry*> shapes;
    for (const PlanLine& line : lines) {
        GEOSCoordSequence* points = GEOSCoordSeq_create_r(geos, 2, 2);
        GEOSCoordSeq_setXY_r(geos, points, 0, line.a.x, line.a.y);
        GEOSCoordSeq_setXY_r(geos, points, 1, line.b.x, line.b.y);
        shapes.push_back(GEOSGeom_createLineString_r(geos, points));
    }
    const Geos::Geometry all = geos.owned(
        GEOSGeom_createCollection_r(geos, GEOS_MULTILINESTRING, shapes.data(), unsigned(shapes.size())));
    return geos.owned(all ? GEOSUnaryUnionPrec_r(geos, all.get(), overlayGridM) : nullptr);
}

// Tries full precision first: snapping to a grid takes several times as long, and GEOS 3.11 may then move a
// corner that two polygons share in only one of them.
Geos::Geometry uniteGeometry(const Geos& geos, const Geos::Geometry& polygons) {
    if (!polygons) return geos.owned(nullptr);
    Geos::Geometry joined = geos.owned(GEOSUnaryUnion_r(geos, polygons.get()));
    if (!joined) joined = geos.owned(GEOSUnaryUnionPrec_r(geos, polygons.get(), overlayGridM));
    if (!joined) return joined;
    return geos.owned(GEOSTopologyPreserveSimplify_r(geos, joined.get(), overlayGridM));
}

Geos::Geometry subtractGeometry(const Geos& geos, const Geos::Geometry& whole, const Geos::Geometry& cover) {
    if (!whole || !cover) return geos.owned(nullptr);
    Geos::Geometry rest = geos.owned(GEOSDifference_r(geos, whole.get(), cover.get()));
    return rest ? std::move(rest)
                : geos.owned(GEOSDifferencePrec_r(geos, whole.get(), cover.get(), overlayGridM));
}

std::vector<Footprint> toPolygons(const Geos& geos, const Geos::Geometry& geometry, bool* sliver,
                                  double minM2) {
    PolygonCollector collector(geos, minM2);
    collector.collect(geometry.get());
    if (sliver != nullptr) *sliver = collector.sliver;
    return std::move(collector.footprints);
}

double computeArea(const Geos& geos, const Geos::Geometry& geometry) {
    double area = 0;
    if (geometry) GEOSArea_r(geos, geometry.get(), &area);
    return area;
}

}  // namespace noonmark
