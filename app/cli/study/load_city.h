#pragma once

#include "app/cli/base/console.h"
#include "app/cli/options/read_options.h"
#include "app/input/load_city.h"

namespace noonmark::cli {

/// Whether one of the files is a project.
bool namesProject(const ReadOptions& options);

/// Error where a project is combined with other files or with reading options: the project states how its
/// city was read. Call it only if namesProject().
Result<void> checkProjectAlone(const ReadOptions& options);

/// Reads the city of a command with a progress line; Ctrl-C cancels. For a project it returns the existing
/// city.
Result<LoadedCity> loadCity(const ReadOptions& options, const Console& console);

}  // namespace noonmark::cli
