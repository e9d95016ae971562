#include "core/io/files/plain_file.h"

#include <gdal_priv.h>

#include "core/base/gdal_calls.h"
#include "core/io/files/open_dataset.h"

namespace noonmark {

Result<const Format*> detectFormatWithGdal(const std::filesystem::path& file, Formats formats) {
    const GdalCalls quiet;  // hides GDAL's messages from the user, who gets ours
    const auto vectors = openDataset(file, DatasetContent::vectors);
    if (vectors && (*vectors)->GetLayerCount() > 0)
        if (const Format* map = findByDriver((*vectors)->GetDriverName(), FileKind::footprints, formats))
            return map;
    const auto raster = openDataset(file, DatasetContent::elevations);
    if (raster && (*raster)->GetRasterCount() > 0)
        if (const Format* terrain = findByDriver((*raster)->GetDriverName(), FileKind::terrain, formats))
            return terrain;
    for (const auto* tried : {&vectors, &raster})
        if (!*tried && !isUnknownFormat(tried->error())) return tl::make_unexpected(tried->error());
    if (std::error_code ignored; std::filesystem::is_directory(file, ignored))
        return failure("This folder is no file geodatabase and holds no Shapefiles", file.string(),
                       "Name the files in it (tiles plan takes a folder of 3D city models)");
    return failure("This file is not in a supported format", file.string(),
                   "Noonmark reads " + listNames({FileKind::footprints, FileKind::cityJson, FileKind::mesh,
                                                  FileKind::terrain},
                                                 formats));
}

}  // namespace noonmark
