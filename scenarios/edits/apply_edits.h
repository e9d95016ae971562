#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/city/city.h"
#include "scenarios/edits/edit.h"

namespace noonmark {

/// Gives every building a unique id (`sourceId`): a second "way 3" becomes "way 3 (2)", a building without id
/// becomes "building" or "building (2)". Shares the buildings whose id does not change. Trees get unique ids
/// likewise, and places in float32, as project files hold them. O(buildings + trees).
City makeIdsUnique(City city);

/// Finds a building by its id, or else by its name. Error: no match, with a similar name as advice; or
/// several buildings of that name, with their ids. O(buildings).
Result<std::size_t> findBuilding(const City& city, const std::string& idOrName);

/// Finds a tree by its id. Error: no match, or the city has no trees. O(trees).
Result<std::size_t> findTree(const City& city, const std::string& id);

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
Result<EditedCity> applyEdits(const City& city, std::span<const Edit> edits);

/// The plan and the top of everything that was removed or added. All changed shadow comes from this volume,
/// so an engine recomputes only where the shadow of this volume falls.
struct ChangedVolume {
    Box2 box;             ///< empty: nothing changed
    float topM = -1e30F;  ///< local z
};
ChangedVolume computeVolume(const CityChanges& changes);

}  // namespace noonmark
