#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/geo/grid.h"

class GDALDataset;
struct GDALDatasetUniquePtrDeleter;

namespace noonmark {

/// Words for GDAL's warper that every resampling of a raster shares: from one coordinate reference system
/// into the cells of a grid in another, in memory, heights left alone, with 256 MB to work in.
std::vector<std::string> makeWarpArguments(const std::string& fromCrs, const std::string& toCrs,
                                           const Grid& grid);

/// The purpose of opening a file, which determines the accepted formats.
enum class DatasetContent {
    vectors,     ///< footprints, regions, lots
    elevations,  ///< rasters of terrain
    pictures,    ///< GeoTIFF and Erdas Imagine: aerial photographs and scanned maps
    maps,        ///< GeoTIFF only: rasters that Noonmark wrote
};

/// GDALDatasetUniquePtr, without GDAL's headers.
using DatasetPointer = std::unique_ptr<GDALDataset, GDALDatasetUniquePtrDeleter>;

/// Opens an untrusted file. No other code in this program gives a file to GDAL. GDAL may try only the drivers
/// of the given content's formats, whatever the file holds or is called; it opens the file for reading,
/// opens files in its folder only, writes nothing beside it and fetches nothing. Hold a GdalCalls. Never
/// returns a null pointer. Error: not a plain file (or a folder of Shapefiles or of a file geodatabase), not
/// one of these formats, a virtual dataset, which names other files, databases or addresses, or beyond a
/// limit: 1,000 layers or bands, 256 MB for a block of a raster, 100 MB for a text or a geometry of a
/// GeoPackage; cancelled() where the GdalCalls was stopped. Backend: open_dataset_gdal.cpp.
Result<DatasetPointer> openDataset(const std::filesystem::path& file, DatasetContent content);

/// Whether openDataset() failed because the content has another format.
bool isUnknownFormat(const Error& error);

/// Opens a GeoTIFF in memory, a file of GDAL's /vsimem/.
Result<DatasetPointer> openMapInMemory(const std::string& name);

}  // namespace noonmark
