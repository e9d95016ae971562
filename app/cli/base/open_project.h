#pragma once

#include <string>

#include "app/cli/base/console.h"
#include "scenarios/project/project_file.h"

namespace noonmark::cli {

/// Opens a project for a command that draws it: with the pixels of its aerial photograph, if it shows one.
/// A photograph that cannot be drawn is a warning on `console.err`. Error: as of ProjectFile::open().
Result<ProjectFile> openProject(const std::string& file, const Console& console);

}  // namespace noonmark::cli
