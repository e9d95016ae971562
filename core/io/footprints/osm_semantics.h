#pragma once

// The folder core/io/osm reads OpenStreetMap and holds its rules. Buildings: osm_map.h reads a file,
// osm_areas.h makes polygons of its ways and relations, read_osm_buildings.h reads their tags, and
// osm_semantics.h (this file) assembles features into buildings, those of other files too. Places and context
// are layers of features (osm_layers.h), so that they are read as those of other formats; other_tags.h parses
// the tags in a converter's column.

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
    Building building;                  ///< z above its own ground
    std::optional<double> elevationM;   ///< elevation of that ground, the lowest that its features state
    std::optional<RoofElevation> roof;  ///< of a building of one feature (HeightReading::roof)
};
std::vector<AssembledBuilding> assembleBuildings(const std::vector<PlacedFeature>& features,
                                                 double metresPerLevel, Warnings& warnings,
                                                 const std::stop_token& stop = {});

}  // namespace noonmark
