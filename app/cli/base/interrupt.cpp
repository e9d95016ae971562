#include "app/cli/base/interrupt.h"

#include <cstdlib>
#include <ctime>
#include <mutex>
#include <vector>

#include "app/cli/base/command_line.h"
#include "core/base/working_files.h"

namespace noonmark::cli {

namespace {

/// The work that listens, the innermost last. Signals go to the process, not to one of its objects.
struct Listeners {
    std::mutex mutex;
    std::vector<std::stop_source> all;
};

Listeners& listeners() {
    static Listeners ofProcess;
    return ofProcess;
}

bool askToStop() {
    const std::lock_guard lock(listeners().mutex);
    return !listeners().all.empty() && listeners().all.back().request_stop();
}

bool isIgnored(int signal) {
    struct sigaction now {};
    return ::sigaction(signal, nullptr, &now) == 0 && now.sa_handler == SIG_IGN;
}

}  // namespace

SignalWatch::SignalWatch() {
    sigemptyset(&signals_);
    for (const int ending : {SIGINT, SIGTERM}) sigaddset(&signals_, ending);
    if (!isIgnored(SIGHUP)) sigaddset(&signals_, SIGHUP);  // a program started by nohup goes on
    pthread_sigmask(SIG_BLOCK, &signals_, &before_);
    watcher_ = std::jthread([this](const std::stop_token& done) { watch(done); });
}

SignalWatch::~SignalWatch() {
    watcher_.request_stop();
    watcher_.join();
    pthread_sigmask(SIG_SETMASK, &before_, nullptr);
}

void SignalWatch::watch(const std::stop_token& done) {
    constexpr timespec glance{0, 50'000'000};  // nanoseconds; the longest wait of the destructor
    while (!done.stop_requested()) {
        if (sigtimedwait(&signals_, nullptr, &glance) < 0 || askToStop()) continue;
        PrivateFolder::removeAllAndStop();
        std::_Exit(exitCancelled);
    }
}

Interrupt::Interrupt() {
    const std::lock_guard lock(listeners().mutex);
    listeners().all.push_back(stop_);
}

Interrupt::~Interrupt() {
    const std::lock_guard lock(listeners().mutex);
    std::erase(listeners().all, stop_);
}

}  // namespace noonmark::cli
