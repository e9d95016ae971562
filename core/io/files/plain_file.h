#pragma once

#include <filesystem>

#include "core/base/result.h"

namespace noonmark {

/// An input must be a plain file, or a folder that is a data set: whoever opens a pipe waits for ever, and a
/// device such as /dev/zero has no end. Links are followed. Error: it is not there, or is no such thing.
Result<void> checkPlainFile(const std::filesystem::path& file);

}  // namespace noonmark
