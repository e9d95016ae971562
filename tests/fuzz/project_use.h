#pragma once

#include <filesystem>

namespace noonmark::tests {

enum class Save { no, yes };

/// Opens a project file and uses all its contents: cities of its scenarios, results and, if requested because
/// it takes most of the time, a save with one more scenario. An Error is acceptable; a project that opens
/// must be valid.
void useProject(const std::filesystem::path& file, Save save);

}  // namespace noonmark::tests
