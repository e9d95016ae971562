#pragma once

#include <chrono>
#include <cstddef>
#include <mutex>
#include <string_view>

namespace noonmark {

/// Receives the progress of long work. Passed together with a std::stop_token, which requests cancellation.
class Progress {
public:
    virtual ~Progress() = default;

    /// `fraction` of the stage done, 0 to 1; `stage` is shown to the user ("tracing rays").
    /// Called from any thread, several at a time; implementations must be thread-safe and quick.
    virtual void report(double fraction, std::string_view stage) = 0;
};

/// Discards all progress.
class NoProgress final : public Progress {
public:
    void report(double, std::string_view) override {}
};

/// Progress of one or more of several equal parts of a longer task: maps the fraction of the part to a
/// fraction of the whole task.
class ProgressShare final : public Progress {
public:
    /// Covers part `index` of `count`, or `parts` parts beginning with it. `whole` must outlive this object.
    ProgressShare(Progress& whole, std::size_t index, std::size_t count, std::size_t parts = 1)
        : whole_(whole), index_(index), count_(count), parts_(parts) {}

    void report(double fraction, std::string_view stage) override {
        whole_.report((double(index_) + fraction * double(parts_)) / double(count_), stage);
    }

private:
    Progress& whole_;
    std::size_t index_, count_, parts_;
};

/// Passes on only what is further than before: threads report out of order, and some work is done again.
class RisingProgress final : public Progress {
public:
    /// `whole` must outlive this object.
    explicit RisingProgress(Progress& whole) : whole_(whole) {}

    void report(double fraction, std::string_view stage) override {
        const std::lock_guard lock(mutex_);
        if (fraction <= last_) return;
        last_ = fraction;
        whole_.report(fraction, stage);
    }

private:
    Progress& whole_;
    std::mutex mutex_;
    double last_ = 0;
};

/// Seconds since construction, by a monotonic clock.
class Stopwatch {
public:
    [[nodiscard]] double seconds() const {
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count();
    }

private:
    std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
};

}  // namespace noonmark
