#pragma once

#include <cstddef>

namespace noonmark {

/// Memory of at least this many bytes, not initialised and aligned to 2 MB, so that the system can map it in
/// huge pages: with few page faults, and few entries of the processor's table of pages. Throws
/// std::bad_alloc. Free it with freeHugePages().
[[nodiscard]] void* allocateHugePages(std::size_t bytes);
void freeHugePages(void* memory);

}  // namespace noonmark
