#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace noonmark::tests {

/// A file or folder of the shared data, which is not part of the project: in NOONMARK_SHARED_DATA, otherwise
/// beside the source folder. Empty where it is missing; the test is then skipped with a message.
std::optional<std::filesystem::path> sharedData(const std::string& relative);

/// A file from the tests folder: "scenarios/files/version-1.noonmark.gpkg". It may be read or copied but not
/// written.
std::filesystem::path testFile(const std::string& relative);

/// A file of the project's sources, to read: "resources/translations/noonmark_de.ts".
std::filesystem::path sourceFile(const std::string& relative);

}  // namespace noonmark::tests
