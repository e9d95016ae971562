#pragma once

#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

#include "core/city/city.h"
#include "core/receivers/rasterize.h"
#include "tests/core/city/footprint_checks.h"

namespace noonmark::tests {

/// Number of cells of a fine raster over a box that lie in more than one building.
inline std::size_t cellsInTwoBuildings(const City& city, const Box2& box, double cellM) {
    const Grid grid{box.low.x, box.low.y, cellM, int((box.high.x - box.low.x) / cellM),
                    int((box.high.y - box.low.y) / cellM)};
    std::vector<std::uint32_t> owner(grid.size());
    std::size_t twice = 0;
    for (std::size_t i = 0; i < city.buildings.size(); ++i)
        for (const Part& part : city.buildings[i]->parts)
            forEachRun(part.footprint, grid, [&](int row, int first, int end) {
                for (int column = first; column < end; ++column) {
                    auto& cell = owner[grid.index(column, row)];
                    twice += cell != 0 && cell != i + 1;
                    cell = std::uint32_t(i + 1);
                }
            });
    return twice;
}

/// The first defect of a building; empty if there is none.
inline std::string faultOf(const Building& building) {
    if (building.parts.empty()) return "no parts";
    for (const Part& part : building.parts) {
        if (!(part.topM > part.bottomM) || part.bottomM < 0) return "no height";
        if (const std::string fault = faultOf(part.footprint); !fault.empty()) return fault;
        if (const std::string fault = faultOfSolid(part.footprint); !fault.empty()) return fault;
    }
    return "";
}

inline bool anyContains(const City& city, glm::dvec2 point) {
    for (const auto& building : city.buildings)
        for (const Part& part : building->parts)
            if (contains(part.footprint, point)) return true;
    return false;
}

/// FNV-1a over the bits of every vertex: equal fingerprints mean cities that are equal to the last bit.
inline std::uint64_t fingerprintOf(const City& city) {
    std::uint64_t hash = 14695981039346656037ULL;
    for (const glm::vec3 vertex : meshOf(city).mesh.vertices)
        for (const float value : {vertex.x, vertex.y, vertex.z}) {
            std::uint32_t bits = 0;
            std::memcpy(&bits, &value, sizeof bits);
            hash = (hash ^ bits) * 1099511628211ULL;
        }
    return hash;
}

}  // namespace noonmark::tests
