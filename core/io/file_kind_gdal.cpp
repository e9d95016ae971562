#include <gdal_priv.h>

#include <memory>

#include "core/io/file_kind.h"
#include "core/io/gdal_calls.h"

namespace noonmark {

namespace {

constexpr const char* readFormats =
    "Noonmark reads GeoJSON, GeoPackage, Shapefile, OpenStreetMap (.osm, .osm.pbf), CityJSON, OBJ, PLY, glTF "
    "and terrain rasters";

// Whether GDAL opens the file in this way; its messages are not for the user, who gets ours.
GDALDatasetUniquePtr openedQuietly(const std::filesystem::path& file, unsigned flags) {
    const GdalCalls quiet;
    return GDALDatasetUniquePtr(GDALDataset::Open(file.string().c_str(), flags | GDAL_OF_READONLY));
}

}  // namespace

Result<FileKind> fileKindFromGdal(const std::filesystem::path& file) {
    const auto vector = openedQuietly(file, GDAL_OF_VECTOR);
    if (vector && vector->GetLayerCount() > 0) return FileKind::footprints;
    const auto raster = openedQuietly(file, GDAL_OF_RASTER);
    if (raster && raster->GetRasterCount() > 0) return FileKind::terrain;
    return failure("This is no file that can be read here", file.string(), readFormats);
}

}  // namespace noonmark
