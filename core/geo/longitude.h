#pragma once

#include <cmath>

namespace noonmark {

/// The same meridian as `lonDeg`, at most 180 degrees from `nearDeg`: next to Fiji -179.9 is 180.1. A ring of
/// such longitudes does not jump where it crosses the antimeridian.
inline double longitudeNear(double lonDeg, double nearDeg) {
    return lonDeg + 360 * std::round((nearDeg - lonDeg) / 360);  // to the last bit where it is near already
}

/// The same meridian, -180 to 180.
inline double usualLongitude(double lonDeg) { return std::remainder(lonDeg, 360.0); }

}  // namespace noonmark
