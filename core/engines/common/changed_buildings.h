#pragma once

#include <memory>
#include <vector>

#include "core/city/building.h"

namespace noonmark {

using Buildings = std::vector<std::shared_ptr<const Building>>;

/// The difference between the buildings of two cities. Buildings are compared by address: an edited city
/// shares the unchanged buildings with the city it was made from.
struct ChangedBuildings {
    Buildings gone, come;  ///< removed and added buildings, with multiplicity, in the order of their own city
    std::size_t first = 0;  ///< all buildings before this index are the same
};

/// One comparison per building if buildings keep their order and only single ones are inserted or removed;
/// otherwise O(buildings) with a hash table.
ChangedBuildings findChangedBuildings(const Buildings& before, const Buildings& after);

/// Makes `buildings` equal to `now`; both are the same up to `first`. Only entries that differ cost more than
/// a comparison.
void updateBuildings(Buildings& buildings, const Buildings& now, std::size_t first);

}  // namespace noonmark
