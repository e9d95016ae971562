#include "core/io/files/pending_file.h"

#include <system_error>
#include <utility>

namespace noonmark {

// Where no folder can be made, the path is in none either, and whoever opens it learns the reason.
PendingFile::PendingFile(std::filesystem::path target)
    : target_(std::move(target)),
      folder_(target_.parent_path()),
      path_((folder_.path().empty() ? target_.parent_path() / ".none" : folder_.path()) /
            target_.filename()) {}

Result<void> PendingFile::commit() {
    std::error_code error;
    std::filesystem::rename(path_, target_, error);
    if (!error) return {};
    return limitReached("The file could not be renamed to its final name: " + error.message(),
                        target_.string(),
                        "Check that the folder can be written to and that no folder has this name");
}

}  // namespace noonmark
