#pragma once

#include <cstdint>
#include <functional>
#include <stop_token>

#include "core/io/footprints/place_features.h"
#include "core/io/osm/osm_map.h"

namespace noonmark {

/// A way or relation that encloses an area. `tags` are valid during the call that receives it.
struct OsmArea {
    bool relation = false;
    std::int64_t id = 0;
    const OsmTags& tags;  ///< of a relation that has none: those of its first outer way with tags
    std::vector<LonLatPolygon> polygons;
};

/// Calls `take` with the multipolygons of relations in the file's order, then with ways by id, except outer
/// rings of a relation, which stands for them. A relation of which a way is missing, or whose ways enclose
/// nothing, is left out. Rings are joined and sorted into outer rings and holes by GDAL, whose remarks on
/// them go to the GdalCalls of this thread. Ends early when stopped. Backend: osm_areas_gdal.cpp.
void forEachOsmArea(const OsmMap& map, const std::function<void(OsmArea)>& take, const std::stop_token& stop);

}  // namespace noonmark
