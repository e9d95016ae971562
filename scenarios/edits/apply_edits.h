#pragma once

#include <memory>
#include <span>
#include <vector>

#include "core/base/result.h"
#include "core/city/city.h"
#include "scenarios/edits/edit.h"

namespace noonmark {

/// The buildings by which an edited city differs from the one it was made of; the same pointers that the
/// two cities hold. A building that was changed is in both lists; one that came and went again is in none.
struct CityChanges {
    std::vector<std::shared_ptr<const Building>> removed;
    std::vector<std::shared_ptr<const Building>> added;
    [[nodiscard]] bool none() const { return removed.empty() && added.empty(); }
};

struct EditedCity {
    City city;  ///< shares every building that did not change, in their order; new ones come last
    CityChanges changes;
};

/// Applies edits one after the other. Error, with the edit's number and words: a building that is not there,
/// an id in use, a value out of range. Each edit costs O(buildings) comparisons of ids, 0.1 ms for 43,000.
Result<EditedCity> applied(const City& city, std::span<const Edit> edits);

/// What the shadow of a change can come from: the plan and the height of all that was removed or added. An
/// engine recomputes where that shadow falls, and nothing else.
struct ChangedVolume {
    Box2 box;             ///< empty: nothing changed
    float topM = -1e30F;  ///< local z
};
ChangedVolume computeVolume(const CityChanges& changes);

}  // namespace noonmark
