#pragma once

// The folder core/io/layers has what readers of vector layers share: reading features, and the coordinate
// system of a layer.

#include <functional>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/gdal_calls.h"
#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/geo/crs_to_lon_lat.h"

class GDALDataset;
class OGRFeature;
class OGRLayer;

namespace noonmark {

/// Takes a feature of the layer of that index. An error ends reading and is returned from it.
using TakeFeature = std::function<Result<void>(std::size_t layer, const OGRFeature& feature)>;

/// How features are read: `what` is shown with the progress ("places of map.osm.pbf").
struct FeatureStream {
    std::string file;  ///< its name in errors
    std::string what;
    double share = 0.8;  ///< of the progress, when all is read
};

/// Reads all features of layers of a dataset: those of OpenStreetMap's driver side by side, as the driver
/// fills them, others one after the other. `calls` must have been made before the dataset was opened. Returns
/// their number. Error: the file is incomplete or damaged; of `take`; cancelled(), also between blocks of a
/// file that hold no usable feature. Backend: feature_stream_gdal.cpp.
Result<std::size_t> readFeatures(GDALDataset& dataset, const std::vector<OGRLayer*>& layers,
                                 const FeatureStream& stream, const GdalCalls& calls, const TakeFeature& take,
                                 Progress& progress, const std::stop_token& stop);

/// Whether the dataset was opened by GDAL's driver for OpenStreetMap.
bool isFromOsm(GDALDataset& dataset);

/// How a map credits OpenStreetMap, whose data the driver reads.
inline constexpr const char* osmCredit = "(c) OpenStreetMap contributors, ODbL";

/// The transformation from a layer's coordinates; `crs` in place of what the layer states. Error: it states
/// none, or one that is not known.
Result<CrsToLonLat> findLayerCrs(OGRLayer& layer, const std::optional<std::string>& crs,
                                 const std::string& file);

/// Without blanks at its ends.
std::string trimmed(std::string_view text);

}  // namespace noonmark
