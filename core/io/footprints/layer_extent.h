#pragma once

#include "core/geo/lon_lat_box.h"
#include "core/io/settings/read_settings.h"

class OGRLayer;

namespace noonmark {

/// Whether the layer finds the features of a window by a spatial index, without reading the others. Backend:
/// layer_extent_gdal.cpp.
bool isIndexed(OGRLayer& layer);

/// Limits the layer to the features that touch the window. False where the window cannot be expressed
/// in the layer's coordinate system.
bool limitToExtent(OGRLayer& layer, const LonLatBox& window, const ReadSettings& settings);

}  // namespace noonmark
