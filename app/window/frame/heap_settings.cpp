#include "app/window/frame/heap_settings.h"

#include <cstdlib>

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace noonmark {

void returnFreedMemory() {
#ifdef __GLIBC__
    constexpr int largeBytes = 1 << 20;
    mallopt(M_MMAP_THRESHOLD, largeBytes);  // an explicit value turns off glibc's adaptive threshold
    mallopt(M_TRIM_THRESHOLD, largeBytes);
#endif
}

}  // namespace noonmark
