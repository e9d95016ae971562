#include "core/geo/lon_lat_box.h"

#include <algorithm>
#include <glm/common.hpp>

namespace noonmark {

void LonLatBox::add(LonLat place) {
    westDeg = std::min(westDeg, place.lonDeg);
    eastDeg = std::max(eastDeg, place.lonDeg);
    southDeg = std::min(southDeg, place.latDeg);
    northDeg = std::max(northDeg, place.latDeg);
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
