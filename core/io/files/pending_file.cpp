#include "core/io/files/pending_file.h"

#include <system_error>
#include <utility>

namespace noonmark {

// Where no folder can be made, nothing can be opened under the path either.
PendingFile::PendingFile(std::filesystem::path target)
    : target_(std::move(target)),
      folder_(target_.parent_path()),
      path_((folder_.path().empty() ? std::filesystem::path("/dev/null") : folder_.path()) /
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
