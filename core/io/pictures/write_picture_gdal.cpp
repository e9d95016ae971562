#include <gdal_priv.h>
#include <ogr_spatialref.h>

#include "core/base/gdal_calls.h"
#include "core/geo/crs_definition.h"
#include "core/io/files/pending_file.h"
#include "core/io/pictures/write_picture.h"

namespace noonmark {

namespace {

GDALDatasetUniquePtr createPicture(const std::filesystem::path& file, const PlacedPicture& picture) {
    GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("GTiff");
    if (driver == nullptr) return nullptr;
    CPLStringList options;
    for (const auto& [name, value] : {std::pair("TILED", "YES"),
                                      {"COMPRESS", "DEFLATE"},
                                      {"PREDICTOR", "2"},
                                      {"PHOTOMETRIC", "RGB"},
                                      {"ALPHA", "NON-PREMULTIPLIED"}})
        options.SetNameValue(name, value);
    return GDALDatasetUniquePtr(
        driver->Create(file.c_str(), picture.columns, picture.rows, 4, GDT_Byte, options.List()));
}

bool fill(GDALDataset& dataset, const PlacedPicture& picture) {
    const auto system = parseCrs(picture.crs);
    if (!system) return false;
    auto place = picture.geoTransform;
    if (!picture.attribution.empty())
        dataset.SetMetadataItem("TIFFTAG_COPYRIGHT", picture.attribution.c_str());
    auto* pixels = const_cast<std::uint8_t*>(picture.rgba.data());  // GDAL only reads through this pointer
    return dataset.SetSpatialRef(&*system) == CE_None && dataset.SetGeoTransform(place.data()) == CE_None &&
           dataset.RasterIO(GF_Write, 0, 0, picture.columns, picture.rows, pixels, picture.columns,
                            picture.rows, GDT_Byte, 4, nullptr, 4, GSpacing(picture.columns) * 4, 1,
                            nullptr) == CE_None;
}

}  // namespace

Result<void> writePicture(const std::filesystem::path& file, const PlacedPicture& picture) {
    const GdalCalls gdal;
    PendingFile pending(file);
    GDALDatasetUniquePtr dataset = createPicture(pending.path(), picture);
    const bool filled = dataset && fill(*dataset, picture);
    dataset.reset();  // flushes: a full disk is reported here
    if (!filled || gdal.failed())
        return limitReached("The picture could not be written: " + gdal.why(), file.string(),
                            "Check that the folder exists, is writable and has space");
    return pending.commit();
}

}  // namespace noonmark
