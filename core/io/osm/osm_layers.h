#pragma once

#include <optional>

#include "core/geo/lon_lat_box.h"
#include "core/io/files/open_dataset.h"
#include "core/io/osm/osm_map.h"

namespace noonmark {

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
