#pragma once

#include <filesystem>
#include <string_view>

namespace noonmark {

/// The format of an output file.
enum class OutputKind {
    geoPackage,  ///< a city, or numbers per building; not a project
    geoJson,
    geoTiff,
    picture,  ///< PNG or JPEG
    pdf,
    table,  ///< CSV
    json,   ///< numbers; neither GeoJSON nor CityJSON nor glTF
    cityJson,
    dxf,  ///< text DXF, not the binary form
    svg,
    movie,    ///< MP4 or GIF
    glb,      ///< binary glTF
    obj,      ///< Wavefront OBJ
    style,    ///< QML, a style of QGIS
    project,  ///< a Noonmark project
};

/// "a GeoPackage"
std::string_view describe(OutputKind kind);

/// The kind of a file whose name the program itself chose, by its extension: "shadow.tif". Other extensions:
/// a table.
OutputKind detectOutputKind(const std::filesystem::path& name);

/// Whether an existing plain file has content of this kind; its name does not matter. An empty file is of
/// every kind, since it has nothing to lose. A file that cannot be read is of none. Reads the beginning; of
/// JSON as far as the first key that identifies the kind.
bool isOfKind(const std::filesystem::path& file, OutputKind kind);

}  // namespace noonmark
