#include "app/cli/interrupt.h"

#include <cstdlib>
#include <ctime>

#include "app/cli/console.h"

namespace noonmark::cli {

Interrupt::Interrupt() {
    sigemptyset(&signals_);
    sigaddset(&signals_, SIGINT);
    sigaddset(&signals_, SIGTERM);
    pthread_sigmask(SIG_BLOCK, &signals_, &before_);
    watcher_ = std::jthread([this](const std::stop_token& done) { watch(done); });
}

Interrupt::~Interrupt() {
    watcher_.request_stop();
    watcher_.join();
    pthread_sigmask(SIG_SETMASK, &before_, nullptr);
}

void Interrupt::watch(const std::stop_token& done) {
    constexpr timespec glance{0, 50'000'000};  // nanoseconds; the longest wait of the destructor
    while (!done.stop_requested()) {
        if (sigtimedwait(&signals_, nullptr, &glance) < 0) continue;
        if (!stop_.request_stop()) std::_Exit(exitCancelled);
    }
}

}  // namespace noonmark::cli
