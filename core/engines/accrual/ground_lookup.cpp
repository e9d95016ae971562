#include "core/engines/accrual/ground_lookup.h"

#include <algorithm>
#include <cmath>

#include "core/simd/simd_lanes.h"

#ifdef NOONMARK_PICKS_ISA
#include <immintrin.h>
#endif

namespace noonmark {

namespace {

// Processes 16 texels; the compiler vectorises this loop.
[[gnu::always_inline]] inline std::uint64_t sixteen(const float* depth, const std::uint32_t* texel,
                                                    float bias) {
    std::uint32_t shaded = 0;
    for (int i = 0; i < 16; ++i) shaded |= depth[texel[i]] > bias ? 1U << unsigned(i) : 0U;
    return shaded;
}

NOONMARK_EVERY_ISA
void lookUpAny(const float* depth, const std::uint32_t* texel, std::size_t words, float bias,
               std::uint64_t* shaded) {
    for (std::size_t word = 0; word < words; ++word, texel += 64)
        shaded[word] = sixteen(depth, texel, bias) | sixteen(depth, texel + 16, bias) << 16U |
                       sixteen(depth, texel + 32, bias) << 32U | sixteen(depth, texel + 48, bias) << 48U;
}

#ifdef NOONMARK_PICKS_ISA
// A comparison yields its 16 bits at once.
[[gnu::target("avx512f")]] void lookUp512(const float* depth, const std::uint32_t* texel, std::size_t words,
                                          float bias, std::uint64_t* shaded) {
    const __m512 biases = _mm512_set1_ps(bias);
    for (std::size_t word = 0; word < words; ++word) {
        std::uint64_t bits = 0;
        for (unsigned first = 0; first < 64; first += 16, texel += 16) {
            const __m512 found = _mm512_mask_i32gather_ps(_mm512_setzero_ps(), 0xFFFF,
                                                          _mm512_loadu_si512(texel), depth, sizeof *depth);
            bits |= std::uint64_t(_mm512_cmp_ps_mask(found, biases, _CMP_GT_OQ)) << first;
        }
        shaded[word] = bits;
    }
}
#endif

void lookUp(const float* depth, const std::uint32_t* texel, std::size_t words, float bias,
            std::uint64_t* shaded) {
#ifdef NOONMARK_PICKS_ISA
    if (__builtin_cpu_supports("avx512f")) return lookUp512(depth, texel, words, bias, shaded);
#endif
    lookUpAny(depth, texel, words, bias, shaded);
}

std::uint64_t lookUpOneByOne(const float* depth, std::span<const std::uint32_t> texels, float bias) {
    std::uint64_t shaded = 0;
    for (std::size_t i = 0; i < texels.size(); ++i)
        shaded |= std::uint64_t(depth[texels[i]] > bias) << unsigned(i);
    return shaded;
}

}  // namespace

GroundLookup::GroundLookup(const Receivers& receivers, const MapFrame& frame, float biasM) : biasM_(biasM) {
    const std::uint32_t stride = DepthSlice(frame.columns, 0).stride;
    const auto nearest = [](double place, int count) {
        return std::uint32_t(std::clamp(int(std::floor(place + 0.5)), 0, count - 1));
    };
    texel_.reserve(receivers.cells.size());
    for (const std::uint32_t cell : receivers.cells) {
        const glm::dvec2 at = frame.texel(frame.placed(receivers.position(cell)), {});
        texel_.push_back(nearest(at.y, frame.rows) * stride + nearest(at.x, frame.columns));
    }
}

void GroundLookup::look(const DepthSlice& slice, std::span<std::uint64_t> shaded) const {
    const std::size_t whole = texel_.size() / 64;
    lookUp(slice.depth.data(), texel_.data(), whole, biasM_, shaded.data());
    if (whole < words())
        shaded[whole] = lookUpOneByOne(slice.depth.data(), std::span(texel_).subspan(whole * 64), biasM_);
}

}  // namespace noonmark
