#pragma once

#include <cstddef>
#include <string>

#include "core/base/result.h"
#include "core/city/city.h"

namespace noonmark {

/// Gives every building a unique id (`sourceId`): a second "way 3" becomes "way 3 (2)", a building without id
/// becomes "building" or "building (2)". Shares the buildings whose id does not change. O(buildings).
City makeIdsUnique(City city);

/// Finds a building by its id, or else by its name. Error: no match, with a similar name as advice; or
/// several buildings of that name, with their ids. O(buildings).
Result<std::size_t> findBuilding(const City& city, const std::string& idOrName);

}  // namespace noonmark
