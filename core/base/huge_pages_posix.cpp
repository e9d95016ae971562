#include <algorithm>
#include <cstdlib>
#include <new>

#include "core/base/huge_pages.h"

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace noonmark {

void* allocateHugePages(std::size_t bytes) {
    constexpr std::size_t pageBytes = std::size_t{2} << 20U;
    const std::size_t whole = (std::max<std::size_t>(bytes, 1) + pageBytes - 1) / pageBytes * pageBytes;
    void* const memory = std::aligned_alloc(pageBytes, whole);
    if (memory == nullptr) throw std::bad_alloc();
#ifdef __linux__
    madvise(memory, whole, MADV_HUGEPAGE);  // a hint; failure is harmless
#endif
    return memory;
}

void freeHugePages(void* memory) { std::free(memory); }

}  // namespace noonmark
