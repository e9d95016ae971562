#pragma once

#include <cstddef>

namespace noonmark {

/// An array that fills one cache line and is aligned to it.
template <class T>
struct alignas(64) CacheLine {
    T values[64 / sizeof(T)] = {};
};

/// Asks the processor to load the cache line at this address, which will soon be written to. The address need
/// not be valid. Has no effect with compilers that have no such instruction.
inline void prefetchForWrite([[maybe_unused]] const void* address) {
#if defined(__GNUC__)
    __builtin_prefetch(address, 1);
#endif
}

/// Asks the processor to load what lies at this address, which will soon be read.
template <class T>
inline void prefetchLines([[maybe_unused]] const T* what) {
#if defined(__GNUC__)
    constexpr std::size_t cacheLine = 64;
    for (std::size_t at = 0; at < sizeof(T); at += cacheLine)
        __builtin_prefetch(reinterpret_cast<const char*>(what) + at);
#endif
}

}  // namespace noonmark
