#include "core/city/terrain/building_ground.h"

#include <algorithm>
#include <optional>

#include "core/city/terrain/ground_contact.h"

namespace noonmark {

float findGroundUnder(const Building& building, const City& city) {
    std::optional<float> lowest;
    for (const Part& part : building.parts)
        if (!part.isOverhanging) lowest = std::min(lowest.value_or(part.bottomM), part.bottomM);
    if (lowest) {  // the lowest volume of a tower may be a twisted one, which counts as an overhang
        for (const Part& part : building.parts)
            if (part.bottomM < *lowest && !part.footprint.outer.empty() &&
                reachesGround(part, groundAt(city, glm::dvec2(part.footprint.outer.front()))))
                lowest = part.bottomM;
        return *lowest;
    }
    const Box2 box = bounds(building);
    return groundAt(city, glm::dvec2(box.low + box.high) / 2.0);
}

float heightM(const Building& building, const City& city) {
    return topM(building) - findGroundUnder(building, city);
}

}  // namespace noonmark
