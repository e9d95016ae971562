#pragma once

namespace noonmark {

/// An array that fills one cache line and is aligned to it.
template <class T>
struct alignas(64) CacheLine {
    T values[64 / sizeof(T)] = {};
};

}  // namespace noonmark
