#pragma once

#include "app/cli/options/sheet_options.h"

namespace noonmark::cli {

/// Adds the options of elements.pdf: those of addSheetOptions(), and --scale of its elevations. `options`
/// must outlive the command.
void addElevationSheetOptions(CLI::App& command, SheetOptions& options);

}  // namespace noonmark::cli
