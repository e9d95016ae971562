#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/result.h"

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

/// Which existing files may be overwritten, and which files have other names than usual.
struct OutputRules {
    /// The files that the output is made from. Their companions (listCompanionFiles) count too, and for a
    /// folder that is a data set all files in it, which also gets no further ones. Names without a file
    /// ("sample:grid") are ignored.
    std::vector<std::filesystem::path> inputs{};
    bool overwrite = false;  ///< a file of the kind that is written may be replaced
    /// The standard name of a file and the one that the user chose: "sheets.pdf", "Mill Lane.pdf".
    std::vector<std::pair<std::string, std::string>> renamed{};
};

/// The name that a file has by the rules.
std::string nameOf(const std::string& standardName, const OutputRules& rules);

/// Whether a file may be written: it does not exist, or rules.overwrite is set and the file is of the given
/// kind. Never overwritten: an input, under any name or link; a project, unless a project is written; a file
/// of another kind; a folder, a pipe, a device, or a dangling link; a database that another program is
/// writing to. The Error states the obstacle, its location and what to do. Writes nothing, and reads only the
/// beginnings of existing files. Call it before long work.
Result<void> checkOutput(const std::filesystem::path& file, OutputKind kind, const OutputRules& rules);

/// The same for several files in one folder, which need not exist; each file's kind is detectOutputKind() of
/// its name. A file that may never be replaced is reported first; otherwise the Error says how many of the
/// files exist.
Result<void> checkOutputs(const std::filesystem::path& folder, const std::vector<std::string>& names,
                          const OutputRules& rules);

/// The names that already exist in the folder.
std::vector<std::string> findExistingOutputs(const std::filesystem::path& folder,
                                             const std::vector<std::string>& names);

}  // namespace noonmark
