#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace noonmark::tests {

/// A file or folder of the shared data (not part of the project): under NOONMARK_SHARED_DATA, else beside the
/// source folder. Nothing where it is missing: the test then skips and says so.
std::optional<std::filesystem::path> sharedData(const std::string& relative);

/// A file that lies among the tests: "scenarios/files/version-1.noonmark.gpkg". Read it, or copy it; never
/// write it.
std::filesystem::path testFile(const std::string& relative);

}  // namespace noonmark::tests
