#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <stop_token>

#include "core/geo/lon_lat.h"
#include "core/io/files/open_dataset.h"
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
/// them go to the GdalCalls of this thread. Ends early when stopped. Backend: osm_layers_gdal.cpp.
void forEachOsmArea(const OsmMap& map, const std::function<void(OsmArea)>& take, const std::stop_token& stop);

/// Reads what is selected of an OpenStreetMap file into memory, as the layers that GDAL's own driver makes:
/// `multipolygons` (fields osm_id of relations, osm_way_id of ways), and if the selection has keys for them,
/// `lines` and `points` (osm_id); beside them a field for each of the selection's keys. Errors of
/// readOsmMap(). Hold a GdalCalls. Backend: osm_layers_gdal.cpp.
Result<DatasetPointer> readOsmLayers(const std::filesystem::path& file, OsmFormat format,
                                     const OsmSelection& selection, Progress& progress,
                                     const std::stop_token& stop);

/// The box that the file of a dataset from readOsmLayers() states to cover; nothing if it states none.
std::optional<LonLatBox> findOsmBox(GDALDataset& dataset);

/// Whether the dataset is from readOsmLayers().
bool isFromOsm(GDALDataset& dataset);

}  // namespace noonmark
