#include "core/base/working_files.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>
#include <cerrno>
#include <cstdlib>
#include <mutex>
#include <set>
#include <system_error>
#include <utility>

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

namespace {

namespace fs = std::filesystem;

/// The folders of this process. A signal ends the whole process, so they have to be known in one place.
class FoldersOfProcess {
public:
    fs::path make(const fs::path& parent) {
        const std::lock_guard lock(mutex_);
        if (ended_) {
            errno = ECANCELED;
            return {};
        }
        std::string pattern = (parent / ".noonmark-XXXXXX").string();
        if (::mkdtemp(pattern.data()) == nullptr) return {};  // exclusive, and only for the user
        return *folders_.insert(pattern).first;
    }
    void remove(const fs::path& folder) {
        const std::lock_guard lock(mutex_);
        folders_.erase(folder);
        removeFiles(folder);
    }
    void removeAllAndStop() {
        const std::lock_guard lock(mutex_);
        ended_ = true;
        for (const fs::path& folder : folders_) removeFiles(folder);
    }

private:
    // Another thread may be adding files until the process ends.
    static void removeFiles(const fs::path& folder) {
        constexpr int maxTries = 20;
        std::error_code error;
        for (int i = 0; i < maxTries; ++i)
            if (fs::remove_all(folder, error); !error) return;
    }

    std::mutex mutex_;
    std::set<fs::path> folders_;
    bool ended_ = false;
};

FoldersOfProcess& foldersOfProcess() {
    static FoldersOfProcess folders;
    return folders;
}

}  // namespace

PrivateFolder::PrivateFolder(const fs::path& parent)
    : path_(foldersOfProcess().make(parent.empty() ? fs::path(".") : parent)) {}

PrivateFolder::PrivateFolder(PrivateFolder&& other) noexcept : path_(std::exchange(other.path_, {})) {}

PrivateFolder::~PrivateFolder() {
    if (!path_.empty()) foldersOfProcess().remove(path_);
}

void PrivateFolder::removeAllAndStop() { foldersOfProcess().removeAllAndStop(); }

bool makeOwnFolder(const fs::path& folder) {
    if (::mkdir(folder.c_str(), S_IRWXU) == 0) return true;
    struct stat found {};
    return ::lstat(folder.c_str(), &found) == 0 && S_ISDIR(found.st_mode) && found.st_uid == ::geteuid() &&
           (found.st_mode & (S_IWGRP | S_IWOTH)) == 0;
}

}  // namespace noonmark
