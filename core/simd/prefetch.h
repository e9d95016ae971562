#pragma once

namespace noonmark {

/// Asks the processor to load the cache line at this address, which will soon be written to. The address need
/// not be valid. Has no effect with compilers that have no such instruction.
inline void prefetchForWrite([[maybe_unused]] const void* address) {
#if defined(__GNUC__)
    __builtin_prefetch(address, 1);
#endif
}

}  // namespace noonmark
