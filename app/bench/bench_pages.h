#pragma once

// The folder app/bench/ writes the report of a benchmark. This file writes all files; bench_pages.cpp lays
// out one finding on a page. Its charts and tables come from chart_painter.h.

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/io/files/check_output.h"
#include "core/lab/bench/bench_report.h"

namespace noonmark {

/// Writes all files of a benchmark into a folder, which is created if missing: one CSV per experiment, named
/// by its key; report.pdf; summary.json. `rules`: which files may be replaced. Returns the paths written. A
/// file is written completely or not at all. Needs a QApplication (the `offscreen` platform suffices).
Result<std::vector<std::filesystem::path>> writeBenchFiles(const bench::BenchReport& report,
                                                           const std::filesystem::path& folder,
                                                           const OutputRules& rules = {});

/// The names of those files for the keys of the findings.
std::vector<std::string> benchFileNames(std::span<const char* const> keys);

}  // namespace noonmark
