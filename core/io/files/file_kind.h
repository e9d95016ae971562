#pragma once

// The folder core/io/files holds what all readers and writers share. Inputs are untrusted: file_kind.h and
// json_kind.h detect a file's kind from its content, plain_file.h refuses pipes and devices, gdal_setup.h
// restricts GDAL, open_dataset.h is the only way from a file to GDAL, geopackage_check.h refuses databases
// that would run SQL. Outputs: check_output.h protects existing files, output_kind.h names the kinds,
// pending_file.h and write_text.h replace a file in one step.

#include <filesystem>

#include "core/base/result.h"

namespace noonmark {

/// The reader of read_part.h that a file belongs to.
enum class FileKind {
    footprints,  ///< readFootprints: vector maps, OpenStreetMap
    cityJson,    ///< readCityJson: CityJSON and CityJSONSeq
    mesh,        ///< readMesh: OBJ, PLY, glTF, glb, IFC, DXF
    terrain,     ///< readTerrain: rasters
};

/// Detects the kind from the content; the name only matters if the content is ambiguous. Reads the beginning
/// of the file; of JSON as far as the first key that identifies the kind. A GeoPackage or a folder is opened
/// with GDAL: it holds footprints if it has vector layers. Error: missing, empty, unreadable, or of an
/// unsupported kind; the advice lists the supported formats.
Result<FileKind> detectFileKind(const std::filesystem::path& file);

/// The kind of a file that GDAL can open but whose beginning does not identify it; the same Error. Backend:
/// file_kind_gdal.cpp.
Result<FileKind> detectFileKindWithGdal(const std::filesystem::path& file);

}  // namespace noonmark
