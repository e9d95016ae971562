#pragma once

#include <cstdint>
#include <filesystem>

#include "core/base/result.h"

namespace noonmark {

/// Refuses files on which the mesh library would run for ever or past its memory: a PLY whose header does not
/// end or promises more than the file holds, a glb that is shorter than it says. Refuses a glTF that names
/// files which are not plain files in its own folder. Looks at the head of the file, and at all of a glTF's
/// JSON. Returns the bytes of the file and of those it names.
Result<std::uintmax_t> checkMeshFile(const std::filesystem::path& file);

/// Whether `companion`, which a mesh file names, is a plain file in the mesh's own folder: no pipe or device,
/// no link that leads elsewhere. `companion` is an absolute path or relative to the working folder.
bool isPlainFileBeside(const std::filesystem::path& companion, const std::filesystem::path& mesh);

}  // namespace noonmark
