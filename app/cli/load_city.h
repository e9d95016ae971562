#pragma once

#include "app/cli/console.h"
#include "app/cli/options/read_options.h"
#include "app/input/load_city.h"

namespace noonmark::cli {

/// Whether one of the files is a project.
bool namesProject(const ReadOptions& options);

/// A project goes without other files and without settings of reading: how its city was read is in it. To be
/// asked where namesProject().
Result<void> checkProjectAlone(const ReadOptions& options);

/// Reads the city of a command with a progress line, stopped by Ctrl-C. Of a project: its city as it stands.
Result<LoadedCity> loadCity(const ReadOptions& options, const Console& console);

}  // namespace noonmark::cli
