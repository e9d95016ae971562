#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "core/base/result.h"

class GDALDataset;
struct GDALDatasetUniquePtrDeleter;

namespace noonmark {

/// What a file is opened for: the formats that may hold it.
enum class DatasetContent {
    vectors,     ///< footprints, regions, lots
    elevations,  ///< rasters of terrain
    maps,        ///< GeoTIFF alone: rasters that Noonmark wrote
};

/// GDALDatasetUniquePtr, without GDAL's headers.
using DatasetPointer = std::unique_ptr<GDALDataset, GDALDatasetUniquePtrDeleter>;

/// Opens a file that a stranger may have made: the only way in this program from a file to GDAL. GDAL may
/// look at it with the drivers of these formats only, whatever it holds and however it is called; it is
/// opened for reading, nothing is written beside it, nothing is fetched. Hold a GdalCalls. `osmOptions`:
/// OPTION=VALUE, where the file is OpenStreetMap. Never returns a null pointer. Error: no plain file (or
/// folder of Shapefiles or of a file geodatabase), none of these formats, or a virtual dataset, which names
/// other files, databases or addresses. Backend: open_dataset_gdal.cpp.
Result<DatasetPointer> openDataset(const std::filesystem::path& file, DatasetContent content,
                                   const std::vector<std::string>& osmOptions = {});

/// Whether openDataset() failed since the content is of another format.
bool isUnknownFormat(const Error& error);

/// The same of a GeoTIFF in memory, a file of GDAL's /vsimem/.
Result<DatasetPointer> openMapInMemory(const std::string& name);

}  // namespace noonmark
