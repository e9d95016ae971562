#pragma once

#include <filesystem>

namespace noonmark::tests {

enum class Save { no, yes };

/// Opens a project file and works with all that it holds: cities of its scenarios, results and, where it is
/// asked for since that takes most of the time, a save with one scenario more. An Error is as good as a
/// project; a project that opened has to be sound.
void useProject(const std::filesystem::path& file, Save save);

}  // namespace noonmark::tests
