#pragma once

#include <sys/inotify.h>
#include <unistd.h>

#include <filesystem>

namespace noonmark::tests {

/// Notes whether anyone opens a file.
class OpenWatch {
public:
    explicit OpenWatch(const std::filesystem::path& file)
        : events_(::inotify_init1(IN_NONBLOCK)),
          watch_(::inotify_add_watch(events_, file.c_str(), IN_OPEN)) {}
    OpenWatch(const OpenWatch&) = delete;
    OpenWatch& operator=(const OpenWatch&) = delete;
    ~OpenWatch() { ::close(events_); }

    [[nodiscard]] bool watching() const { return watch_ >= 0; }
    /// Whether the file was opened since it was last asked.
    [[nodiscard]] bool wasOpened() const {
        bool opened = false;
        for (char event[4096]; ::read(events_, event, sizeof event) > 0;) opened = true;
        return opened;
    }

private:
    int events_, watch_;
};

}  // namespace noonmark::tests
