#pragma once

#include <memory>
#include <span>
#include <vector>

#include "core/base/result.h"
#include "core/city/city.h"
#include "scenarios/edits/edit.h"

namespace noonmark {

/// The buildings in which an edited city differs from the city before; the pointers are those that the two
/// cities hold. A changed building is in both lists; a building that was added and removed again is in
/// neither.
struct CityChanges {
    std::vector<std::shared_ptr<const Building>> removed;
    std::vector<std::shared_ptr<const Building>> added;
    [[nodiscard]] bool none() const { return removed.empty() && added.empty(); }
};

struct EditedCity {
    City city;  ///< shares unchanged buildings and keeps their order; new buildings come last
    CityChanges changes;
};

/// Applies edits one after the other. Error, with the number and text of the edit: a building does not exist,
/// an id is in use, or a value is out of range. Each edit compares O(buildings) ids: 0.1 ms for 43,000
/// buildings.
Result<EditedCity> applied(const City& city, std::span<const Edit> edits);

/// The plan and the top of everything that was removed or added. All changed shadow comes from this volume,
/// so an engine recomputes only where the shadow of this volume falls.
struct ChangedVolume {
    Box2 box;             ///< empty: nothing changed
    float topM = -1e30F;  ///< local z
};
ChangedVolume computeVolume(const CityChanges& changes);

}  // namespace noonmark
