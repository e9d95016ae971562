#pragma once

#include <filesystem>

namespace noonmark::tests {

/// Opens a project file and works with all that it holds: cities of its scenarios, results, a save with one
/// scenario more. An Error is as good as a project; a project that opened has to be sound.
void useProject(const std::filesystem::path& file);

}  // namespace noonmark::tests
