#pragma once

#include <csignal>
#include <stop_token>
#include <thread>

namespace noonmark::cli {

/// During its lifetime Ctrl-C (SIGINT) and SIGTERM request a stop instead of ending the program; a second
/// signal ends it at once with code 130. Create it before other threads, which inherit that these signals are
/// blocked.
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
