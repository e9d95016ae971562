#pragma once

#include <csignal>
#include <stop_token>
#include <thread>

namespace noonmark::cli {

/// Takes the signals by which a user or a scheduler ends a program: Ctrl-C (SIGINT), SIGTERM, and SIGHUP of a
/// terminal that is closed. The work that listens (Interrupt) is asked to stop; if none does, or the one that
/// does was asked before, the process ends at once with code 130, without files that are not finished.
/// Create it before other threads, which inherit that these signals are blocked.
class SignalWatch {
public:
    SignalWatch();
    ~SignalWatch();
    SignalWatch(const SignalWatch&) = delete;
    SignalWatch& operator=(const SignalWatch&) = delete;

private:
    void watch(const std::stop_token& done);

    sigset_t signals_{};
    sigset_t before_{};
    std::jthread watcher_;
};

/// During its lifetime the first of these signals requests a stop instead of ending the program.
class Interrupt {
public:
    Interrupt();
    ~Interrupt();
    Interrupt(const Interrupt&) = delete;
    Interrupt& operator=(const Interrupt&) = delete;

    [[nodiscard]] std::stop_token token() const { return stop_.get_token(); }

private:
    std::stop_source stop_;
    SignalWatch watch_;
};

}  // namespace noonmark::cli
