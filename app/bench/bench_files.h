#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/bench/bench_report.h"
#include "core/io/files/check_output.h"

namespace noonmark {

/// Everything a benchmark leaves, into a folder that is made when missing: one CSV an experiment, named by
/// its key; report.pdf; summary.json. `rules`: what may be replaced. Returns the paths written. Each file is
/// whole or not there. Needs a QApplication (the `offscreen` platform will do).
Result<std::vector<std::filesystem::path>> writeBenchFiles(const bench::BenchReport& report,
                                                           const std::filesystem::path& folder,
                                                           const OutputRules& rules = {});

/// The names of those files, by the keys of the findings.
std::vector<std::string> benchFileNames(std::span<const char* const> keys);

}  // namespace noonmark
