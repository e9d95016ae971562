#pragma once

#include <memory>
#include <vector>

#include "core/city/building.h"

namespace noonmark {

using Buildings = std::vector<std::shared_ptr<const Building>>;

/// What became of a city's buildings. They are told apart by their address: a city shares with the one it was
/// made from what did not change.
struct ChangedBuildings {
    Buildings gone, come;   ///< each as often as the other city lacks it, in the order of its own city
    std::size_t first = 0;  ///< before this one all are the same
};

/// One comparison each where buildings stay in place or move up or down by one at a time; else O(buildings)
/// in a table.
ChangedBuildings findChangedBuildings(const Buildings& before, const Buildings& after);

/// From now on those of another city, which are the same up to `first`. Costs something only for those that
/// are not in place.
void updateBuildings(Buildings& buildings, const Buildings& now, std::size_t first);

}  // namespace noonmark
