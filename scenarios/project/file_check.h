#pragma once

#include <filesystem>

#include "core/base/result.h"

namespace noonmark {

/// Whether a file is there, readable, an SQLite file, and as long as its head says. Looks at the first 100
/// bytes only. Files with a journal beside them are SQLite's to judge.
Result<void> checkWhole(const std::filesystem::path& file);

/// Whether the file may be written, also by the mark that root is not held to.
Result<void> checkWritable(const std::filesystem::path& file);

}  // namespace noonmark
