#pragma once

#include <chrono>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <stop_token>
#include <thread>

namespace noonmark::bench {

/// A stop token that stops when `outer` does, or after `seconds`; without a time limit if `seconds` is
/// infinite or more than a year.
class Deadline {
public:
    Deadline(double seconds, const std::stop_token& outer)
        : relay_(outer, [this] { source_.request_stop(); }) {
        constexpr double yearS = 365.0 * 24 * 3600;
        if (seconds < yearS)
            timer_ = std::jthread([this, seconds](const auto& done) { wait(done, seconds); });
    }
    Deadline(const Deadline&) = delete;
    Deadline& operator=(const Deadline&) = delete;

    [[nodiscard]] std::stop_token token() const { return source_.get_token(); }
    /// Stops immediately; may be called from any thread.
    void giveUp() { source_.request_stop(); }

private:
    void wait(const std::stop_token& done, double seconds) {
        std::unique_lock lock(mutex_);
        woken_.wait_for(lock, done, std::chrono::duration<double>(seconds), [] { return false; });
        if (!done.stop_requested()) source_.request_stop();
    }

    std::stop_source source_;
    std::stop_callback<std::function<void()>> relay_;
    std::mutex mutex_;
    std::condition_variable_any woken_;
    std::jthread timer_;  // last: must end before the members it uses
};

}  // namespace noonmark::bench
