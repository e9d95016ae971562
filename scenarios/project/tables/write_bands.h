#pragma once

#include "scenarios/project/project.h"
#include "scenarios/project/tables/database.h"

namespace noonmark {

/// Beside the cells of a kept layer, which a GIS shows in grey: their bands as polygons in the colours of the
/// program, in the layer `tiles`_bands. For people; never read back. Throws DatabaseTrouble.
void writeBands(Database& database, const SavedResult& result, const SavedLayer& layer,
                const std::string& tiles);
void removeBands(Database& database, const std::string& tiles);  ///< nothing where there are none

}  // namespace noonmark
