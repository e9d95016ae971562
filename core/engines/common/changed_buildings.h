#pragma once

#include <cstdint>
#include <memory>
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

/// With one city all buildings are common. O(buildings log buildings).
SharedBuildings findSharedBuildings(std::span<const City* const> cities);

using Buildings = std::vector<std::shared_ptr<const Building>>;

/// The difference between the buildings of two cities. Buildings are compared by address: an edited city
/// shares the unchanged buildings with the city it was made from.
struct ChangedBuildings {
    Buildings removed,
        added;  ///< removed and added buildings, with multiplicity, in the order of their own city
    std::size_t first = 0;  ///< all buildings before this index are the same
};

/// One comparison per building if buildings keep their order and only single ones are inserted or removed;
/// otherwise O(buildings) with a hash table.
ChangedBuildings findChangedBuildings(const Buildings& before, const Buildings& after);

/// Makes `buildings` equal to `now`; both are the same up to `first`. Only entries that differ cost more than
/// a comparison.
void updateBuildings(Buildings& buildings, const Buildings& now, std::size_t first);

}  // namespace noonmark
