#include "core/io/files/write_text.h"

#include <fstream>
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

Result<void> writeText(const std::filesystem::path& file, std::string_view text) {
    PendingFile pending(file);
    std::ofstream stream(pending.path(), std::ios::binary);
    stream.write(text.data(), std::streamsize(text.size()));
    stream.close();
    if (!stream)
        return limitReached("The file could not be written", file.string(),
                            "Choose a folder that you may write to, and check that the disk has space");
    return pending.commit();
}

}  // namespace noonmark
