#pragma once

#include <memory>
#include <vector>

#include "core/city/footprints/footprint.h"
#include "core/city/footprints/plan_overlay.h"
#include "core/city/footprints/repair_footprint.h"

// Forward declarations of GEOS's types, so that only files with geos in their name need its header.
struct GEOSGeom_t;
struct GEOSContextHandle_HS;

namespace noonmark {

/// A GEOS context that suppresses messages; failures are null pointers, also after a stop request to this
/// thread's StopScope. Cheap to make; not thread-safe.
/// Backend of this whole file: geos_shapes_geos.cpp.
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

/// A polygon from an outline and its holes, unchanged, valid or not; each ring has at least three points.
/// Null if GEOS fails.
Geos::Geometry makePolygonGeometry(const Geos& geos, const std::vector<RawRing>& rings);

/// A multipolygon of the given polygons, which may overlap, so that it need not be valid. Takes ownership of
/// `polygons`.
Geos::Geometry collection(const Geos& geos, std::vector<GEOSGeom_t*> polygons);
Geos::Geometry collection(const Geos& geos, const std::vector<Footprint>& footprints);

/// Lines cut at their intersections, duplicates removed, snapped to a millimetre. Null if the result is
/// empty.
Geos::Geometry nodeLines(const Geos& geos, const std::vector<PlanLine>& lines);

/// The union of a collection, without points within 1 mm of straight lines. Null if GEOS fails even on a grid
/// of 1 mm.
Geos::Geometry uniteGeometry(const Geos& geos, const Geos::Geometry& polygons);

/// `whole` minus `cover`; null if GEOS fails even on a grid of 1 mm, or if an argument is null.
Geos::Geometry subtractGeometry(const Geos& geos, const Geos::Geometry& whole, const Geos::Geometry& cover);

/// Smaller polygons are not pieces of a building, m2.
inline constexpr double sliverAreaM2 = 0.01;

/// Every polygon in a geometry, oriented. Points that coincide in float32 are merged. Polygons and holes
/// under `minM2` are dropped; `sliver`, if given, is then set to true.
std::vector<Footprint> toPolygons(const Geos& geos, const Geos::Geometry& geometry, bool* sliver = nullptr,
                                  double minM2 = sliverAreaM2);

/// Square metres; 0 for null.
double computeArea(const Geos& geos, const Geos::Geometry& geometry);

/// Precision grid of overlays, metres: finer than any survey, coarse enough to remove rounding errors.
inline constexpr double overlayGridM = 0.001;

}  // namespace noonmark
