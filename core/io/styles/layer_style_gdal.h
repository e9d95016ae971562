#pragma once

#include "core/io/styles/layer_style.h"

class GDALDataset;
class OGRLayer;

namespace noonmark {

/// Puts the style of a layer into the GeoPackage that is being written; nothing where it has no QML. Errors
/// are GDAL's: see GdalCalls.
void writeLayerStyle(GDALDataset& geoPackage, OGRLayer& layer, const LayerStyle& style);

}  // namespace noonmark
