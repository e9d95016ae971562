#include "tests/shared/shared_data.h"

#include <cstdlib>

namespace noonmark::tests {

std::optional<std::filesystem::path> sharedData(const std::string& relative) {
    const char* set = std::getenv("NOONMARK_SHARED_DATA");
    const std::filesystem::path root =
        set != nullptr ? std::filesystem::path(set)
                       : std::filesystem::path(NOONMARK_SOURCE_DIR) / ".." / "shared" / "data";
    std::error_code ignored;
    const auto path = root / relative;
    if (!std::filesystem::exists(path, ignored)) return std::nullopt;
    return path;
}

std::filesystem::path testFile(const std::string& relative) {
    return std::filesystem::path(NOONMARK_SOURCE_DIR) / "tests" / relative;
}

std::filesystem::path sourceFile(const std::string& relative) {
    return std::filesystem::path(NOONMARK_SOURCE_DIR) / relative;
}

}  // namespace noonmark::tests
