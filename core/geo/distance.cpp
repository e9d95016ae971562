#include "core/geo/distance.h"

#include <algorithm>
#include <cmath>

namespace noonmark {

// Haversine: accurate for small distances too.
double computeGreatCircleM(LonLat a, LonLat b) {
    constexpr double earthRadiusM = 6371000;
    const auto radians = [](double degrees) { return Degrees{degrees}.radians().value; };
    const double dLat = std::sin(radians(b.latDeg - a.latDeg) / 2);
    const double dLon = std::sin(radians(b.lonDeg - a.lonDeg) / 2);
    const double h = dLat * dLat + std::cos(radians(a.latDeg)) * std::cos(radians(b.latDeg)) * dLon * dLon;
    return 2 * earthRadiusM * std::asin(std::sqrt(std::clamp(h, 0.0, 1.0)));
}

}  // namespace noonmark
