#pragma once

#include <memory>
#include <vector>

#include "core/city/footprints/footprint.h"
#include "core/city/footprints/plan_lines.h"
#include "core/city/footprints/repair_footprint.h"

// GEOS's own names, so that its header is needed only by files that bear its name.
struct GEOSGeom_t;
struct GEOSContextHandle_HS;

namespace noonmark {

/// A GEOS context that says nothing; its failures are null pointers. Cheap to make; not for two threads.
/// Backend: geos_shapes_geos.cpp, like all here.
class Geos {
public:
    Geos();
    Geos(const Geos&) = delete;
    Geos& operator=(const Geos&) = delete;
    ~Geos();
    operator GEOSContextHandle_HS*() const { return context_; }

    struct Destroy {
        GEOSContextHandle_HS* context;
        void operator()(GEOSGeom_t* geometry) const;
    };
    using Geometry = std::unique_ptr<GEOSGeom_t, Destroy>;
    [[nodiscard]] Geometry owned(GEOSGeom_t* geometry) const { return {geometry, Destroy{context_}}; }

private:
    GEOSContextHandle_HS* context_;
};

/// An outline, then its holes, as they are, valid or not; each of at least three points. Null where GEOS
/// fails.
Geos::Geometry makePolygonGeometry(const Geos& geos, const std::vector<RawRing>& rings);

/// Polygons as GEOS has them, in one multipolygon that need not be valid; they may overlap. Takes `polygons`
/// over.
Geos::Geometry collection(const Geos& geos, std::vector<GEOSGeom_t*> polygons);
Geos::Geometry collection(const Geos& geos, const std::vector<Footprint>& footprints);

/// Lines, each once, cut where they meet; what lies within a millimetre is one. Null for none.
Geos::Geometry nodeLines(const Geos& geos, const std::vector<PlanLine>& lines);

/// The union of a collection, without points within 1 mm of straight lines. Null where GEOS fails even on a
/// grid of 1 mm.
Geos::Geometry uniteGeometry(const Geos& geos, const Geos::Geometry& polygons);

/// What `cover` leaves of `whole`; null where GEOS fails even on a grid of 1 mm, or is given null.
Geos::Geometry subtractGeometry(const Geos& geos, const Geos::Geometry& whole, const Geos::Geometry& cover);

/// Every polygon in a geometry, oriented; points that fall together in float32 are one; polygons and holes
/// under 0.01 m2 are left out, and `sliver`, where given, becomes true then.
std::vector<Footprint> toPolygons(const Geos& geos, const Geos::Geometry& geometry, bool* sliver = nullptr);

/// Square metres; 0 for null.
double computeArea(const Geos& geos, const Geos::Geometry& geometry);

/// The grid that overlays snap to, metres: finer than any survey, coarse enough that nothing is left of
/// rounding.
inline constexpr double overlayGridM = 0.001;
/// What is smaller is no piece of a building, m2.
inline constexpr double sliverAreaM2 = 0.01;

}  // namespace noonmark
