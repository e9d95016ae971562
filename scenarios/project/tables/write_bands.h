#pragma once

#include "scenarios/project/project.h"
#include "scenarios/project/tables/database.h"

namespace noonmark {

/// GIS programs show the cells of a saved layer in grey. This adds the bands of the layer as polygons in the
/// program's colours, in the layer `tiles`_bands. The program never reads them back. Throws DatabaseTrouble.
void writeBands(Database& database, const SavedResult& result, const SavedLayer& layer,
                const std::string& tiles);
void removeBands(Database& database, const std::string& tiles);  ///< no effect where there are none

}  // namespace noonmark
