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
#include "core/geo/crs.h"

class GDALDataset;
class OGRFeature;
class OGRLayer;
class OGRSpatialReference;

namespace noonmark {

/// Takes a feature of the layer of that index. An error ends reading and is returned from it.
using TakeFeature = std::function<Result<void>(std::size_t layer, const OGRFeature& feature)>;

/// How features are read: `what` is shown with the progress (NM_TEXT: "reading places").
struct FeatureStream {
    std::string file;  ///< its name in errors
    std::string_view what;
    double share = 0.8;  ///< of the progress, when all is read
};

/// Reads all features of the layers, one layer after the other. `calls` must have been made before the
/// dataset was opened. Returns their number. Error: the file is incomplete or damaged; of `take`;
/// cancelled(). Backend: feature_stream_gdal.cpp.
Result<std::size_t> readFeatures(const std::vector<OGRLayer*>& layers, const FeatureStream& stream,
                                 const GdalCalls& calls, const TakeFeature& take, Progress& progress,
                                 const std::stop_token& stop);

/// How a map credits OpenStreetMap.
inline constexpr const char* osmCredit = "(c) OpenStreetMap contributors, ODbL";

/// The transformation from a layer's coordinates; `crs` in place of what the layer states. Error: it states
/// none, one that is not known, or one that names a file.
Result<CrsToLonLat> findLayerCrs(OGRLayer& layer, const std::optional<std::string>& crs,
                                 const std::string& file);

/// The system itself, in the order of findLayerCrs(), which must have accepted it. Empty if there is none.
OGRSpatialReference findLayerSystem(OGRLayer& layer, const std::optional<std::string>& crs);

/// The index of the field that the user named, in any case. Error: there is none; it lists the fields.
Result<int> findNamedField(OGRLayer& layer, const std::string& name, const std::string& file);

}  // namespace noonmark
