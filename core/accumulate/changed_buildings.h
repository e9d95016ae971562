#pragma once

#include <memory>
#include <vector>

#include "core/city/building.h"

namespace noonmark {

using Buildings = std::vector<std::shared_ptr<const Building>>;

/// What became of a city's buildings. They are told apart by their address: a city shares with the one it was
/// made from what did not change.
struct ChangedBuildings {
    Buildings gone, come;  ///< each as often as the other city lacks it, in the order of its own city
};

/// O(buildings) where some follow on each other that did not stay in place; else one comparison each.
ChangedBuildings changedBuildings(const Buildings& before, const Buildings& after);

}  // namespace noonmark
