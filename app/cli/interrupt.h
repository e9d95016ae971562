#pragma once

#include <csignal>
#include <stop_token>
#include <thread>

namespace noonmark::cli {

/// While it lives, Ctrl-C (SIGINT) and SIGTERM ask for a stop instead of ending the program; the second one
/// ends it at once with code 130. Make it before other threads are started: they inherit that these signals
/// are not theirs.
class Interrupt {
public:
    Interrupt();
    ~Interrupt();
    Interrupt(const Interrupt&) = delete;
    Interrupt& operator=(const Interrupt&) = delete;

    [[nodiscard]] std::stop_token token() const { return stop_.get_token(); }

private:
    void watch(const std::stop_token& done);

    sigset_t signals_{};
    sigset_t before_{};
    std::stop_source stop_;
    std::jthread watcher_;
};

}  // namespace noonmark::cli
