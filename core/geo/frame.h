#pragma once

// The folder core/geo relates a project's local metres to the earth: Frame, the local plane (this file);
// Grid, a raster in that plane (grid.h); the transformation of files' coordinates to longitude and latitude
// (crs_to_lon_lat.h); the earth's curvature (earth_drop.h); great-circle distances (distance.h); and
// longitudes near the antimeridian (longitude.h).

#include <glm/mat2x2.hpp>
#include <glm/vec2.hpp>
#include <string>

#include "core/base/units.h"

namespace noonmark {

/// The project's local coordinates, metres: x east, y north of an origin on the WGS84 ellipsoid (the
/// horizontal part of east-north-up at the origin), z above the origin's ground. Terrain, and buildings whose
/// ground elevation is stated, are lowered by the earth's curvature (earth_drop.h). True north is +y at the
/// origin.
///
/// A value; cheap to copy. A round trip is exact to better than 1 mm within 50 km of the origin; not meant
/// for points more than 1,000 km away.
class Frame {
public:
    Frame() = default;
    /// `originElevationM`: elevation of local z = 0 above the vertical datum of the data, metres.
    explicit Frame(LonLat origin, double originElevationM = 0);

    [[nodiscard]] LonLat origin() const { return origin_; }
    [[nodiscard]] double originElevationM() const { return originElevationM_; }

    [[nodiscard]] glm::dvec2 localFromLonLat(LonLat place) const;
    [[nodiscard]] LonLat lonLatFromLocal(glm::dvec2 local) const;

    /// The directions of true east and north at a place, in this plane: the differential of localFromLonLat,
    /// local metres per metre of ground. Its columns are the images of east and of north. North turns against
    /// +y by the convergence, about (lon - origin's lon) x sin(lat); lengths along the line to the origin
    /// shrink by the cosine of the angle at the earth's centre: by 0.003 % at 50 km.
    [[nodiscard]] glm::dmat2 localFromEastNorth(LonLat place) const;

    /// The same plane as a coordinate reference system for GIS files: ellipsoidal orthographic (EPSG method
    /// 9840), whose eastings and northings are local x and y.
    [[nodiscard]] std::string projString() const;

    bool operator==(const Frame&) const = default;

private:
    LonLat origin_{};
    double originElevationM_ = 0;
};

}  // namespace noonmark
