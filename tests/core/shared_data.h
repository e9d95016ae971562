#pragma once

#include <cstdlib>
#include <filesystem>
#include <optional>
#include <string>

namespace noonmark::tests {

/// A file or folder of the shared data (not part of the project): under NOONMARK_SHARED_DATA, else beside the source folder.
/// Nothing where it is missing: the test then skips and says so.
inline std::optional<std::filesystem::path> sharedData(const std::string& relative) {
    const char* set = std::getenv("NOONMARK_SHARED_DATA");
    const std::filesystem::path root =
        set != nullptr ? std::filesystem::path(set) : std::filesystem::path(NOONMARK_SOURCE_DIR) / ".." / "shared" / "data";
    std::error_code ignored;
    const auto path = root / relative;
    if (!std::filesystem::exists(path, ignored)) return std::nullopt;
    return path;
}

}  // namespace noonmark::tests
