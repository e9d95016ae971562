#pragma once

#include <cstddef>
#include <string>

#include "core/base/result.h"
#include "core/city/city.h"

namespace noonmark {

/// The city with an id (`sourceId`) of its own for every building: a second "way 3" becomes "way 3 (2)", one
/// without an id "building" or "building (2)". Shares the buildings that keep theirs. O(buildings).
City makeIdsUnique(City city);

/// The building that a user means: its id, or else its name. Error: none, with a near one, or several of that
/// name, with their ids. O(buildings).
Result<std::size_t> findBuilding(const City& city, const std::string& idOrName);

}  // namespace noonmark
