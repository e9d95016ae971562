#include "core/engines/horizon/sweep/tile_horizons.h"

#include <algorithm>
#include <cstdlib>
#include <new>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace noonmark {

namespace {

// The codes take hundreds of megabytes; they are written once, bin by bin, and read across bins. Huge pages
// of this size are mapped with few page faults, and reading across bins moves only a page or two from one bin
// to the next.
constexpr std::size_t pageBytes = std::size_t{2} << 20U;

HorizonCode* allocated(std::size_t count) {
    const std::size_t bytes =
        (std::max<std::size_t>(count * sizeof(HorizonCode), 1) + pageBytes - 1) / pageBytes * pageBytes;
    void* memory = std::aligned_alloc(pageBytes, bytes);
    if (memory == nullptr) throw std::bad_alloc();
#ifdef __linux__
    madvise(memory, bytes, MADV_HUGEPAGE);  // a hint; failure is harmless
#endif
    return static_cast<HorizonCode*>(memory);
}

}  // namespace

TileHorizons::TileHorizons(std::size_t bins, std::size_t numbers)
    : numbers_(numbers), codes_(allocated(bins * numbers)) {}

}  // namespace noonmark
