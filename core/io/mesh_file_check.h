#pragma once

#include <filesystem>

#include "core/result.h"

namespace noonmark {

/// Refuses files on which the mesh library would run for ever or past its memory: a PLY whose header does not
/// end or promises more than the file holds, a glb that is shorter than it says. Looks at the head of the
/// file only.
Result<void> checkMeshFile(const std::filesystem::path& file);

}  // namespace noonmark
