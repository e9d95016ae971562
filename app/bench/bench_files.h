#pragma once

#include <filesystem>
#include <vector>

#include "core/bench/bench_report.h"
#include "core/result.h"

namespace noonmark {

/// Everything a benchmark leaves, into a folder that is made when missing: one CSV an experiment, named by
/// its key; report.pdf; summary.json. Returns the paths written. Each file is whole or not there. Needs a
/// QApplication (the `offscreen` platform will do).
Result<std::vector<std::filesystem::path>> writeBenchFiles(const bench::BenchReport& report,
                                                           const std::filesystem::path& folder);

}  // namespace noonmark
