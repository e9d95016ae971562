#pragma once

#include <cmath>

namespace noonmark {

/// The longitude of the same meridian that is at most 180 degrees from `nearDeg`: next to Fiji, -179.9
/// becomes 180.1. A ring of such longitudes does not jump at the antimeridian.
inline double wrapLongitudeNear(double lonDeg, double nearDeg) {
    // leaves a longitude that is near already unchanged to the last bit
    return lonDeg + 360 * std::round((nearDeg - lonDeg) / 360);
}

/// The longitude of the same meridian in -180 to 180.
inline double wrapLongitude(double lonDeg) { return std::remainder(lonDeg, 360.0); }

}  // namespace noonmark
