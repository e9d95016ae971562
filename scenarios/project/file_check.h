#pragma once

#include <filesystem>

#include "core/base/result.h"

namespace noonmark {

/// Checks that a file exists, is readable, is an SQLite file, has the length that its header states, and that
/// what lies beside it is harmless (checkBeside). Reads only the first 100 bytes. The length is not checked
/// where a journal lies beside the file: SQLite recovers it.
Result<void> checkWhole(const std::filesystem::path& file);

/// Checks that the file is writable. A file without any write permission counts as read-only for root, too.
Result<void> checkWritable(const std::filesystem::path& file);

}  // namespace noonmark
