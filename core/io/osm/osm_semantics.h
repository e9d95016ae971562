#pragma once

// The folder core/io/osm holds the rules of OpenStreetMap: osm_configuration.h makes GDAL's driver deliver
// the needed tags, other_tags.h parses the remaining ones, and osm_semantics.h (this file) assembles features
// into buildings. The reader itself is core/io/footprints.

#include <optional>
#include <stop_token>
#include <vector>

#include "core/base/warnings.h"
#include "core/city/building.h"
#include "core/io/footprints/part_grouping.h"

namespace noonmark {

/// Assembles features into buildings by OpenStreetMap's rules for simple 3D buildings, which also hold for
/// files without parts: see groupIntoBuildings, computeRemainder and settleParts. Canopies (building=roof)
/// without a stated underside are overhangs. Ends early when stopped.
struct AssembledBuilding {
    Building building;                 ///< z above its own ground
    std::optional<double> elevationM;  ///< elevation of that ground, the lowest that its features state
};
std::vector<AssembledBuilding> assembleBuildings(const std::vector<PlacedFeature>& features,
                                                 double metresPerLevel, Warnings& warnings,
                                                 const std::stop_token& stop = {});

}  // namespace noonmark
