#pragma once

#include "core/io/trees/read_trees.h"

class GDALDataset;

namespace noonmark {

/// The cells of a raster of canopy heights above the ground, metres, as trees of their own: cylinders of the
/// cell's area (TreeFacts::canopyCellM2). Cells below 2 m are no canopy. Hold a GdalCalls. Error: no place or
/// no system, cells of more than 20 m, no canopy, or more than 2 million cells of it; cancelled(). Backend:
/// read_canopy_gdal.cpp.
Result<TreesRead> readCanopy(GDALDataset& dataset, const std::string& file,
                             const std::optional<std::string>& crs, Progress& progress,
                             const std::stop_token& stop);

}  // namespace noonmark
