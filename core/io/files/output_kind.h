#pragma once

#include <filesystem>
#include <string_view>

namespace noonmark {

/// What a file is written as.
enum class OutputKind {
    geoPackage,  ///< a city, or figures of its buildings; not a project
    geoJson,
    geoTiff,
    picture,  ///< PNG or JPEG
    pdf,
    table,    ///< CSV
    json,     ///< figures: neither GeoJSON nor CityJSON nor glTF
    project,  ///< a Noonmark project
};

/// "a GeoPackage"
std::string_view describe(OutputKind kind);

/// The kind of a file that the program names itself, by its ending: "shadow.tif". Other endings: a table.
OutputKind detectOutputKind(const std::filesystem::path& name);

/// Whether a plain file that is there has content of a kind; its name does not count. An empty file is of
/// every kind: it has nothing to lose. A file that cannot be read is of none. Reads the head, of JSON as far
/// as the first telling key.
bool isOfKind(const std::filesystem::path& file, OutputKind kind);

}  // namespace noonmark
