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

/// Takes polygons of one coordinate system to local metres. Not for two threads at once. Backend:
/// polygon_layer_gdal.cpp.
class PolygonLayer {
public:
    /// `crs` may be null. `where`: the file, for messages. Error: no system, or none that is known.
    static Result<PolygonLayer> of(const OGRSpatialReference* crs, const Frame& frame,
                                   const std::string& where);

    /// Every polygon of the geometry, of its collections and curves too, repaired where it is invalid; long
    /// sides are bent as the projection bends them. Error: a point where the system cannot be, or more than
    /// 200 km from the frame's origin.
    [[nodiscard]] Result<std::vector<Footprint>> polygons(const OGRGeometry& geometry) const;

    /// Whether it can reach into the box, by its envelope; far less work than polygons(). Never says no
    /// wrongly of a geometry of less than 1 km.
    [[nodiscard]] bool mayReach(const OGRGeometry& geometry, const Box2& box) const;

private:
    PolygonLayer(CrsToLonLat toLonLat, double longestSide, const Frame& frame, std::string where);
    using LocalRing = std::vector<glm::dvec2>;
    Result<void> add(const OGRGeometry& geometry, std::vector<Footprint>& pieces) const;
    [[nodiscard]] Result<LocalRing> localRing(const std::vector<glm::dvec2>& points) const;

    CrsToLonLat toLonLat_;
    double longestSide_ = 0;  // in the system's units
    bool inDegrees_ = false;  // longitudes are unwrapped next to the frame before sides are cut up
    Frame frame_;
    std::string where_;
};

/// Error for a place that no study around the frame's origin can mean: more than 200 km away.
Result<void> checkedNear(LonLat place, const Frame& frame, const std::string& where);

}  // namespace noonmark
