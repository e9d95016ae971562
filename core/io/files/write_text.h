#pragma once

#include <filesystem>
#include <string_view>

#include "core/base/result.h"

namespace noonmark {

/// Writes a text file completely or not at all: under a temporary name in the same folder, then renamed.
/// Error: the folder does not allow it, or the disk is full.
Result<void> writeText(const std::filesystem::path& file, std::string_view text);

}  // namespace noonmark
