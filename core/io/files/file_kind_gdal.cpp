#include <gdal_priv.h>

#include "core/base/gdal_calls.h"
#include "core/io/files/file_kind.h"
#include "core/io/files/open_dataset.h"

namespace noonmark {

namespace {
constexpr const char* readFormats =
    "Noonmark reads GeoJSON, GeoPackage, Shapefile, FlatGeobuf, GML, OpenStreetMap (.osm, .osm.pbf), "
    "CityJSON, "
    "OBJ, PLY, glTF, IFC, DXF and terrain rasters (GeoTIFF and others)";
}  // namespace

Result<FileKind> detectFileKindWithGdal(const std::filesystem::path& file) {
    const GdalCalls quiet;  // hides GDAL's messages from the user, who gets ours
    const auto vectors = openDataset(file, DatasetContent::vectors);
    if (vectors && (*vectors)->GetLayerCount() > 0) return FileKind::footprints;
    const auto raster = openDataset(file, DatasetContent::elevations);
    if (raster && (*raster)->GetRasterCount() > 0) return FileKind::terrain;
    for (const auto* tried : {&vectors, &raster})
        if (!*tried && !isUnknownFormat(tried->error())) return tl::make_unexpected(tried->error());
    return failure("This file is not in a supported format", file.string(), readFormats);
}

}  // namespace noonmark
