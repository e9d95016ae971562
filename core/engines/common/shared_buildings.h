#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/city/city.h"

namespace noonmark {

/// The buildings of several cities, divided into those that all share (the same object, as edited cities
/// share what an edit did not change) and the rest. Indices in City::buildings, ascending.
struct SharedBuildings {
    std::vector<std::uint32_t> common;            ///< in the first city
    std::vector<std::vector<std::uint32_t>> own;  ///< one list a city
};

/// Of one city all buildings are common. O(buildings log buildings).
SharedBuildings findSharedBuildings(std::span<const City* const> cities);

}  // namespace noonmark
