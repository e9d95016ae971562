#pragma once

#include <memory>
#include <string>

#include "core/city/city.h"

/// Small synthetic cities for the tests of scenarios.
namespace noonmark::tests {

inline Footprint box(float west, float south, float east, float north) {
    return {{{west, south}, {east, south}, {east, north}, {west, north}}, {}};
}

inline Building house(const std::string& id, const Footprint& footprint, float topM, float bottomM = 0) {
    Building building{.sourceId = id, .name = id};
    building.parts.push_back({.sourceId = id, .footprint = footprint, .bottomM = bottomM, .topM = topM});
    return building;
}

inline std::shared_ptr<const Building> shared(Building building) {
    return std::make_shared<const Building>(std::move(building));
}

/// Three houses of 10 x 10 m along the x axis, 30 m apart: "a" is 10 m, "b" 20 m, "c" 30 m high.
inline City threeHouses() {
    City city;
    city.frame = Frame({-73.97, 40.76});
    city.buildings = {shared(house("a", box(0, 0, 10, 10), 10)), shared(house("b", box(30, 0, 40, 10), 20)),
                      shared(house("c", box(60, 0, 70, 10), 30))};
    return city;
}

/// Ground that rises to the east by 1 m per 10 m, from z = 0 at x = 0.
inline std::shared_ptr<const Terrain> slope() {
    Terrain terrain{Grid{.westM = -5, .southM = -55, .cellM = 10, .columns = 30, .rows = 12}, {}};
    for (int row = 0; row < terrain.grid.rows; ++row)
        for (int column = 0; column < terrain.grid.columns; ++column)
            terrain.elevationM.push_back(float(column));
    return std::make_shared<const Terrain>(std::move(terrain));
}

}  // namespace noonmark::tests
