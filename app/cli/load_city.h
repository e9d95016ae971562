#pragma once

#include "app/cli/console.h"
#include "app/cli/read_options.h"
#include "app/input/load_city.h"

namespace noonmark::cli {

/// Reads the city of a command with a progress line, stopped by Ctrl-C.
Result<LoadedCity> loadCity(const ReadOptions& options, const Console& console);

}  // namespace noonmark::cli
