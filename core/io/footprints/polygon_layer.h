#pragma once

#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/city/footprints/footprint.h"
#include "core/geo/crs_to_lon_lat.h"
#include "core/geo/frame.h"

class OGRGeometry;
class OGRSpatialReference;

namespace noonmark {

/// Transforms polygons of one coordinate system to local metres. Not thread-safe. Backend:
/// polygon_layer_gdal.cpp.
class PolygonLayer {
public:
    /// `crs` may be null. `where`: the file, for messages. Error: no system, or an unknown one.
    static Result<PolygonLayer> of(const OGRSpatialReference* crs, const Frame& frame,
                                   const std::string& where);

    /// Every polygon of the geometry, including collections and curves, repaired if invalid; long sides get
    /// extra points, so that they follow the curves of the projection. Error: a point that the system cannot
    /// have, or that is more than 200 km from the frame's origin; a polygon of more than maxOutlinePoints.
    [[nodiscard]] Result<std::vector<Footprint>> polygons(const OGRGeometry& geometry) const;

    /// Whether the geometry may reach into the box, judged by its envelope; much cheaper than polygons().
    /// Never wrongly false for a geometry smaller than 1 km.
    [[nodiscard]] bool mayReach(const OGRGeometry& geometry, const Box2& box) const;

private:
    PolygonLayer(CrsToLonLat toLonLat, double longestSide, const Frame& frame, std::string where);
    using LocalRing = std::vector<glm::dvec2>;
    Result<void> add(const OGRGeometry& geometry, std::vector<Footprint>& pieces) const;
    [[nodiscard]] Result<LocalRing> localRing(const std::vector<glm::dvec2>& points) const;

    CrsToLonLat toLonLat_;
    double longestSide_ = 0;  // in the system's units
    bool inDegrees_ = false;  // longitudes are unwrapped near the frame's before sides are divided
    Frame frame_;
    std::string where_;
};

/// Error for a place more than 200 km from the frame's origin, which no study there can mean.
Result<void> checkedNear(LonLat place, const Frame& frame, const std::string& where);

}  // namespace noonmark
