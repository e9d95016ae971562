#pragma once

#include <filesystem>

#include "core/base/result.h"

namespace noonmark {

/// Recognises, by their beginning, files of formats that are common where cities are described but are not
/// read here: CityGML, point clouds, drawings, models, tables. Error: of kind `unsupported`, with the
/// format's name and what to do. Nothing is wrong with other files, and with those that cannot be opened.
/// Reads 8 KiB at most.
Result<void> refuseForeignFormat(const std::filesystem::path& file);

}  // namespace noonmark
