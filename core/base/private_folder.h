#pragma once

#include <filesystem>

namespace noonmark {

/// A new folder for files in the making. Nobody can guess its name or enter it but the user, so that no link
/// can wait in it for what is written. Removed with all it holds at the end.
class PrivateFolder {
public:
    /// Makes it in a folder that exists. If that is not possible, path() is empty; lastSystemProblem() tells
    /// why.
    explicit PrivateFolder(const std::filesystem::path& parent);
    PrivateFolder(PrivateFolder&& other) noexcept;
    PrivateFolder& operator=(PrivateFolder&&) = delete;
    ~PrivateFolder();

    [[nodiscard]] const std::filesystem::path& path() const { return path_; }

    /// Removes all that exist, and makes none from now on: call it before the process ends without running
    /// destructors, at a signal.
    static void removeAllForGood();

private:
    std::filesystem::path path_;
};

/// Makes a folder, or takes one that is there if it belongs to this user and nobody else may write to it.
/// False if neither is possible.
bool makeOwnFolder(const std::filesystem::path& folder);

}  // namespace noonmark
