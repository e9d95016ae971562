#pragma once

#include <filesystem>

#include "core/base/result.h"

namespace noonmark {

/// Checks that an input is a plain file, or a folder that is a data set: opening a pipe can block for ever,
/// and a device such as /dev/zero has no end. Links are followed. Error: it does not exist, or is something
/// else.
Result<void> checkPlainFile(const std::filesystem::path& file);

/// Checks that what the program writes by itself, in a folder that a stranger may have packed, does not lead
/// elsewhere: it is a plain file or folder and no link, or is not there yet.
Result<void> checkNoLink(const std::filesystem::path& fileOrFolder);

}  // namespace noonmark
