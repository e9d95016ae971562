#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace noonmark {

/// A file that one process at a time appends to. Standard streams can neither lock a file nor shorten one
/// that is open; working_files_posix.cpp does. The lock ends with the object, or with the process, however it
/// ends.
class LockedFile {
public:
    enum class State {
        open,
        usedByOther,  ///< another process has locked it
        failed,       ///< it could not be opened; lastSystemProblem() states why
    };
    /// Opens the file, or creates it, and locks it. Does not wait, and follows no link.
    explicit LockedFile(const std::filesystem::path& file);
    LockedFile(LockedFile&& other) noexcept;
    LockedFile& operator=(LockedFile&& other) noexcept = delete;
    ~LockedFile();

    [[nodiscard]] State state() const { return state_; }

    /// Removes all bytes from this one on. False on failure.
    [[nodiscard]] bool shorten(std::uint64_t bytes);
    /// Writes at the end, in one call of the system as a rule. False on failure.
    [[nodiscard]] bool append(std::string_view text);

private:
    int file_ = -1;
    State state_ = State::failed;
};

/// Why the last call to the system on this thread failed, in words.
std::string lastSystemProblem();

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
    static void removeAllAndStop();

private:
    std::filesystem::path path_;
};

/// Makes a folder, or takes one that is there if it belongs to this user and nobody else may write to it.
/// False if neither is possible.
bool makeOwnFolder(const std::filesystem::path& folder);

}  // namespace noonmark
