#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "core/city/building.h"

namespace noonmark {

/// A building that is in the city twice, as positions in the list.
struct SameBuilding {
    std::size_t kept = 0, dropped = 0;
    bool byId = false;  ///< both have the same id; otherwise the same outline
};

/// Finds buildings that are there twice: two of the same id that are equally high and share more than half of
/// the smaller outline, or any two whose outlines share at least 95 % of the larger and that overlap over
/// half of the lower one's height. Kept is the one whose heights are better known (stated before storeys,
/// those before assumed), then the higher one, then the first. Of three the best one stays. Each is dropped
/// once at most. O(n log n).
std::vector<SameBuilding> findSameBuildings(const std::vector<std::shared_ptr<const Building>>& buildings);

}  // namespace noonmark
