#pragma once

#include <optional>
#include <stop_token>
#include <vector>

#include "core/base/warnings.h"
#include "core/city/building.h"
#include "core/io/footprints/part_grouping.h"

namespace noonmark {

/// Buildings of features, by the rules of OpenStreetMap's simple 3D buildings, which also hold for files
/// without parts: see groupedIntoBuildings, remainderOf and settleParts. Canopies (building=roof) whose
/// underside is not in the data hang. Ends early when stopped.
struct AssembledBuilding {
    Building building;                 ///< z above its own ground
    std::optional<double> elevationM;  ///< of that ground, the lowest that its features state
};
std::vector<AssembledBuilding> assembleBuildings(const std::vector<PlacedFeature>& features,
                                                 double metresPerLevel, Warnings& warnings,
                                                 const std::stop_token& stop = {});

}  // namespace noonmark
