#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>
#include <utility>

#include "core/base/locked_file.h"

namespace noonmark {

LockedFile::LockedFile(const std::filesystem::path& file)
    : file_(::open(file.c_str(), O_CREAT | O_RDWR | O_APPEND | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK, 0644)) {
    if (file_ < 0) return;
    state_ = ::flock(file_, LOCK_EX | LOCK_NB) == 0 ? State::open : State::usedByOther;
}

LockedFile::LockedFile(LockedFile&& other) noexcept
    : file_(std::exchange(other.file_, -1)), state_(std::exchange(other.state_, State::failed)) {}

LockedFile::~LockedFile() {
    if (file_ >= 0) ::close(file_);
}

bool LockedFile::shorten(std::uint64_t bytes) { return ::ftruncate(file_, off_t(bytes)) == 0; }

bool LockedFile::append(std::string_view text) {
    while (!text.empty()) {
        const ssize_t wrote = ::write(file_, text.data(), text.size());
        if (wrote < 0 && errno != EINTR) return false;
        text.remove_prefix(wrote > 0 ? std::size_t(wrote) : 0);
    }
    return true;
}

std::string lastSystemProblem() { return std::system_category().message(errno); }

}  // namespace noonmark
