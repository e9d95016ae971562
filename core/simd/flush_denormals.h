#pragma once

#include <cstdint>

#if defined(__SSE__)
#include <pmmintrin.h>
#include <xmmintrin.h>
#endif

namespace noonmark {

/// While it lives, the calling thread treats denormal floats as 0, as Embree recommends, because each
/// operation on one costs hundreds of cycles. The destructor restores the thread's previous mode, so other
/// work on the thread is unaffected. Has no effect where the compiler offers no access to the mode.
class FlushDenormals {
public:
    FlushDenormals(const FlushDenormals&) = delete;
    FlushDenormals& operator=(const FlushDenormals&) = delete;
#if defined(__SSE__)
    FlushDenormals() : before_(_mm_getcsr()) {
        _mm_setcsr(before_ | _MM_FLUSH_ZERO_ON | _MM_DENORMALS_ZERO_ON);
    }
    ~FlushDenormals() { _mm_setcsr(before_); }

private:
    unsigned before_;
#elif defined(__aarch64__) && (defined(__GNUC__) || defined(__clang__))
    FlushDenormals() {
        asm volatile("mrs %0, fpcr" : "=r"(before_));
        setMode(before_ | flushBit);
    }
    ~FlushDenormals() { setMode(before_); }

private:
    static constexpr std::uint64_t flushBit = std::uint64_t{1} << 24U;  // FPCR.FZ
    static void setMode(std::uint64_t mode) { asm volatile("msr fpcr, %0" : : "r"(mode)); }
    std::uint64_t before_;
#else
    FlushDenormals() = default;
#endif
};

}  // namespace noonmark
