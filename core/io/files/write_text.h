#pragma once

#include <filesystem>
#include <string_view>

#include "core/base/result.h"

namespace noonmark {

/// The text as a file, whole or not at all: written beside its place and renamed. Error: the folder does not
/// allow it, or has no room.
Result<void> writeText(const std::filesystem::path& file, std::string_view text);

}  // namespace noonmark
