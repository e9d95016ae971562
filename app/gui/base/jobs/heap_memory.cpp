#include "app/gui/base/jobs/heap_memory.h"

#ifdef __GLIBC__
#include <malloc.h>

#include <atomic>
#include <chrono>
#endif

namespace noonmark {

#ifdef __GLIBC__

void returnLargeBlocks() {
    constexpr int largeBytes = 1 << 20;
    mallopt(M_MMAP_THRESHOLD, largeBytes);  // an explicit value turns off glibc's adaptive threshold
    mallopt(M_TRIM_THRESHOLD, largeBytes);
}

void trimHeap() {
    using Clock = std::chrono::steady_clock;
    static std::atomic<Clock::time_point> last{Clock::time_point{}};
    constexpr std::chrono::seconds pause{2};
    Clock::time_point before = last;
    const Clock::time_point now = Clock::now();
    if (now - before >= pause && last.compare_exchange_strong(before, now)) malloc_trim(0);
}

#else

void returnLargeBlocks() {}
void trimHeap() {}

#endif

}  // namespace noonmark
