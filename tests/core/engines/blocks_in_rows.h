#pragma once

#include <cstdint>
#include <random>
#include <vector>

#include "tests/core/engines/scenes.h"

namespace noonmark::tests {

/// High blocks in rows, with gaps of 0.3 to 2 m between them, narrower than a bin from most receivers.
inline std::vector<Box3> rowsOfBlocks(std::uint32_t seed) {
    std::mt19937 random(seed);
    const auto between = [&](double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random);
    };
    std::vector<Box3> boxes;
    for (double south = 0; south < 160; south += 40)
        for (double west = between(0, 10), east = 0; west < 160; west = east + between(0.3, 2)) {
            east = west + between(8, 25);
            boxes.push_back(
                {glm::dvec3(glm::vec3(glm::dvec3(west, south, 0))),
                 glm::dvec3(glm::vec3(glm::dvec3(east, south + between(6, 15), between(40, 150))))});
        }
    return boxes;
}

}  // namespace noonmark::tests
