#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/io/files/check_output.h"
#include "scenarios/project/project.h"

namespace noonmark {

/// result.tif and result.json.
std::vector<std::string> savedFileNames();

/// Writes the maps of a saved result, a band each, and its settings and figures as they were saved. `frame`
/// of the project's city. Returns the paths written; all files or none.
Result<std::vector<std::filesystem::path>> writeSavedFiles(const SavedResult& result, const Frame& frame,
                                                           const std::filesystem::path& folder,
                                                           const OutputRules& rules = {});

}  // namespace noonmark
