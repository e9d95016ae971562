#include "core/io/files/pending_file.h"

#include <fmt/format.h>

#include <atomic>
#include <system_error>

#include "core/base/process.h"

namespace noonmark {

namespace {
std::filesystem::path pendingName(const std::filesystem::path& target) {
    static std::atomic<unsigned> made{0};
    const std::string name =
        fmt::format(".{}.{}-{}{}", target.stem().string(), processId(), made++, target.extension().string());
    return target.parent_path() / name;
}
}  // namespace

PendingFile::PendingFile(std::filesystem::path target)
    : target_(std::move(target)), path_(pendingName(target_)) {}

PendingFile::~PendingFile() {
    std::error_code ignored;
    std::filesystem::remove(path_, ignored);
}

Result<void> PendingFile::commit() {
    std::error_code error;
    std::filesystem::rename(path_, target_, error);
    if (!error) return {};
    return limitReached("The file could not be renamed to its final name: " + error.message(),
                        target_.string(),
                        "Check that the folder can be written to and that no folder has this name");
}

}  // namespace noonmark
