#include "core/geo/lon_lat.h"

#include <algorithm>
#include <glm/common.hpp>

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

void LonLatBox::add(LonLat place) {
    westDeg = std::min(westDeg, place.lonDeg);
    eastDeg = std::max(eastDeg, place.lonDeg);
    southDeg = std::min(southDeg, place.latDeg);
    northDeg = std::max(northDeg, place.latDeg);
}

LonLatBox growBox(LonLatBox box, double byM) {
    constexpr double metresPerDegree = 111000;  // at least that of a degree of latitude but near the poles
    const double latitude = byM / metresPerDegree;
    box.southDeg = std::max(-90.0, box.southDeg - latitude);
    box.northDeg = std::min(90.0, box.northDeg + latitude);
    const double farthest = Degrees{std::max(std::abs(box.southDeg), std::abs(box.northDeg))}.radians().value;
    const double longitude = std::min(360.0, latitude / std::max(1e-6, std::cos(farthest)));
    box.westDeg -= longitude, box.eastDeg += longitude;
    return box;
}

// Parallels are curved in the local plane: points along the sides, and a margin for the arc between two
// points.
LonLatBox makeLonLatBox(const Frame& frame, glm::dvec2 lowM, glm::dvec2 highM) {
    constexpr int pieces = 32;
    constexpr double marginM = 1;
    const double longest = std::max(highM.x - lowM.x, highM.y - lowM.y) / pieces;
    const double arcM = longest * longest / 1e6;  // exceeds the sagitta up to a latitude of 85 degrees
    const glm::dvec2 low = lowM - (marginM + arcM), high = highM + (marginM + arcM);
    LonLatBox box = emptyLonLatBox;
    for (int i = 0; i <= pieces; ++i) {
        const glm::dvec2 at = glm::mix(low, high, double(i) / pieces);
        for (const glm::dvec2 point : {glm::dvec2(at.x, low.y), glm::dvec2(at.x, high.y),
                                       glm::dvec2(low.x, at.y), glm::dvec2(high.x, at.y)})
            box.add(frame.lonLatFromLocal(point));
    }
    if (box.eastDeg - box.westDeg > 180) box.westDeg = -180, box.eastDeg = 180;
    return box;
}

}  // namespace noonmark
