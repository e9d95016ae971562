#pragma once

#include "app/cli/base/console.h"
#include "app/cli/options/sheet_options.h"
#include "app/cli/options/study_options.h"

namespace noonmark::cli {

/// Runs `study` at points (--receivers facades, windows, plane): reads, measures, writes the files and prints
/// a table, or study.json. Returns the exit code.
int runElements(const StudyOptions& options, const SheetOptions& layout, const Console& console);

}  // namespace noonmark::cli
