#pragma once

#include <filesystem>

#include "core/base/result.h"

namespace noonmark {

/// Which reader of read_part.h a file belongs to.
enum class FileKind {
    footprints,  ///< readFootprints: vector maps, OpenStreetMap
    cityJson,    ///< readCityJson: CityJSON and CityJSONSeq
    mesh,        ///< readMesh: OBJ, PLY, glTF, glb
    terrain,     ///< readTerrain: rasters
};

/// Known from the content; the name is not looked at where the content is enough. Reads the head of the file,
/// of JSON as far as the first telling key. A GeoPackage or a folder is asked through GDAL: footprints if it
/// has vector layers. Error: not there, empty, not readable, or of no kind that is read; the advice names the
/// formats.
Result<FileKind> detectFileKind(const std::filesystem::path& file);

/// What GDAL says of a file whose head tells nothing; the same Error. Backend: file_kind_gdal.cpp.
Result<FileKind> detectFileKindWithGdal(const std::filesystem::path& file);

}  // namespace noonmark
