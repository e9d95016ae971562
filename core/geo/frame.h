#pragma once

// The folder core/geo relates a project's local metres to the earth: Frame, the local plane, and the earth's
// curvature (this file); Grid, a raster in that plane (grid.h); the transformation of files' coordinates to
// longitude and latitude (crs.h); great-circle distances and longitudes near the antimeridian (lon_lat.h).

#include <glm/mat2x2.hpp>
#include <glm/vec2.hpp>
#include <string>

#include "core/base/units.h"

namespace noonmark {

/// The project's local coordinates, metres: x east, y north of an origin on the WGS84 ellipsoid (the
/// horizontal part of east-north-up at the origin), z above the origin's ground. Terrain, and buildings whose
/// ground elevation is stated, are lowered by the earth's curvature (earthDropM()). True north is +y at the
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

inline constexpr double meanEarthRadiusM = 6'371'009;  ///< IUGG
/// Gauss's coefficient of refraction, as a share of the earth's curvature
inline constexpr double rayBending = 0.13;

/// How far the earth's surface lies below the tangent plane at the project's origin, as a horizontal ray sees
/// it, metres: d2 (1 - k) / 2R. R = 6,371,009 m, the mean radius (IUGG); k = 0.13, Gauss's coefficient of
/// refraction: rays near the ground bend with the earth's surface. This is consistent with sun positions that
/// include refraction. 7 cm at 1 km, 6.8 m at 10 km, 246 m at 60 km.
///
/// Lowering elevations by this drop turns them into heights above that plane, the plane that the sun's
/// direction refers to, so that all engines get the horizon of a distant ridge right. Neglected: k varies
/// with the weather; between k = 0 and twice the value used here, a horizon at 30 km moves by some 0.02 deg.
inline double earthDropM(glm::dvec2 local) {
    return (local.x * local.x + local.y * local.y) * (1 - rayBending) / (2 * meanEarthRadiusM);
}

/// Slope of that drop at a point, metres per metre towards the east and the north: 0.008 deg for each km from
/// the origin.
inline glm::dvec2 earthDropSlope(glm::dvec2 local) { return local * ((1 - rayBending) / meanEarthRadiusM); }

}  // namespace noonmark
