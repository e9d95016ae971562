#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace noonmark {

/// A file that one process at a time appends to. Standard streams can neither lock a file nor shorten one
/// that is open; locked_file_posix.cpp does. The lock ends with the object, or with the process, however it
/// ends.
class LockedFile {
public:
    enum class State {
        open,
        usedByOther,  ///< another process has locked it
        failed,       ///< it could not be opened; lastSystemProblem() tells why
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

}  // namespace noonmark
