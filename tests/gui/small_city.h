#pragma once

#include "core/city/city.h"

namespace noonmark::test {

/// A square, given by its south-western corner.
inline Footprint square(glm::vec2 corner, float sideM) {
    return {{corner, corner + glm::vec2(sideM, 0), corner + glm::vec2(sideM), corner + glm::vec2(0, sideM)},
            {}};
}

/// Three boxes in New York: 60, 25 and 90 m high.
inline City smallCity() {
    City city;
    city.frame = Frame({-73.98, 40.76});
    const auto add = [&city](const char* name, glm::vec2 corner, float sideM, float topM) {
        Building building;
        building.sourceId = building.name = name;
        Part part;
        part.footprint = square(corner, sideM);
        part.topM = topM;
        part.heightSource = HeightSource::measured;
        building.parts.push_back(part);
        city.buildings.push_back(std::make_shared<const Building>(building));
    };
    add("South House", {-20, -60}, 40, 60);
    add("Low House", {60, 20}, 30, 25);
    add("Tower", {-100, 30}, 25, 90);
    return city;
}

}  // namespace noonmark::test
