#pragma once

#include <cmath>

#include "core/base/units.h"
#include "core/geo/frame.h"

namespace noonmark {

/// Metres between two places along the earth's surface, taken as a sphere: accurate to 0.5 %, which is enough
/// to tell near from far. Valid all round the earth, where a local plane folds back beyond its horizon. NaN
/// for NaN.
double computeGreatCircleM(LonLat a, LonLat b);

/// The longitude of the same meridian that is at most 180 degrees from `nearDeg`: next to Fiji, -179.9
/// becomes 180.1. A ring of such longitudes does not jump at the antimeridian.
inline double wrapLongitudeNear(double lonDeg, double nearDeg) {
    // leaves a longitude that is near already unchanged to the last bit
    return lonDeg + 360 * std::round((nearDeg - lonDeg) / 360);
}

/// The longitude of the same meridian in -180 to 180.
inline double wrapLongitude(double lonDeg) { return std::remainder(lonDeg, 360.0); }

/// A box in longitude and latitude. West is the smaller number: boxes do not cross the antimeridian.
struct LonLatBox {
    double westDeg = 0, southDeg = 0, eastDeg = 0, northDeg = 0;
    bool operator==(const LonLatBox&) const = default;

    [[nodiscard]] bool touches(const LonLatBox& other) const {
        return westDeg <= other.eastDeg && eastDeg >= other.westDeg && southDeg <= other.northDeg &&
               northDeg >= other.southDeg;
    }
    void add(LonLat place);
};

/// A box without a point in it, to add places to.
inline constexpr LonLatBox emptyLonLatBox{1e9, 1e9, -1e9, -1e9};

/// The box with some metres more to each side, not beyond the poles.
LonLatBox growBox(LonLatBox box, double byM);

/// A box around the local box from `lowM` to `highM`, with a margin of a metre. It covers all longitudes
/// where the local box reaches across the antimeridian.
LonLatBox makeLonLatBox(const Frame& frame, glm::dvec2 lowM, glm::dvec2 highM);

}  // namespace noonmark
