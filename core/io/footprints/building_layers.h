#pragma once

#include <vector>

#include "core/base/warnings.h"

class GDALDataset;
class OGRLayer;

namespace noonmark {

/// Whether a layer's type of geometry is polygons, or any.
bool mayHavePolygons(OGRLayer& layer);

/// The polygon layers of a file that hold buildings. One polygon layer is taken as it is. Of several, those
/// whose name says building are; else, of those that neither their name (plots, streets, districts) nor their
/// shapes, which fill the ground, exclude, those with fields of buildings (heights, storeys, OpenStreetMap's
/// tags); else the rest of these; else all. Of a file that Noonmark wrote, its own. Each layer that is left
/// out gives a warning that says why and how to read it, and so does each of several that are read. Backend:
/// building_layers_gdal.cpp.
std::vector<OGRLayer*> chooseBuildingLayers(GDALDataset& dataset, Warnings& warnings);

}  // namespace noonmark
