#pragma once

#include <cstdint>
#include <filesystem>

#include "core/base/result.h"

namespace noonmark {

/// Refuses files on which the mesh library would run for ever or exhaust memory: a PLY whose header does not
/// end or promises more than the file holds, a glb that is shorter than it says. Also refuses an IFC or a
/// DXF in text form without the mark at its end, as part of the model is missing, and a glTF that names
/// files other than plain files in its own folder. Reads the beginning and the end of the file, and all of a
/// glTF's JSON. Returns the size of the file and the files that it names, bytes.
Result<std::uintmax_t> checkMeshFile(const std::filesystem::path& file);

/// Whether `companion`, a file named by a mesh file, is a plain file in the mesh's own folder: no pipe or
/// device, no link that leads elsewhere. `companion` is an absolute path or relative to the working folder.
bool isPlainFileBeside(const std::filesystem::path& companion, const std::filesystem::path& mesh);

}  // namespace noonmark
