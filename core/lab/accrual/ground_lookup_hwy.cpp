#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/lab/accrual/ground_lookup_hwy.cpp"
#include <hwy/foreach_target.h>

#include <algorithm>
#include <cmath>

#include "core/lab/accrual/shadow_accrual_map.h"
#include "core/simd/kernel.h"

HWY_BEFORE_NAMESPACE();
namespace noonmark::HWY_NAMESPACE {

// Whole words of 64 texels; one bit per texel.
void lookUpWords(const float* depth, const std::uint32_t* texel, std::size_t words, float bias,
                 std::uint64_t* shaded) {
    constexpr LanesUpTo<float, 64> d;
    constexpr hn::RebindToSigned<decltype(d)> di;
    const auto biases = hn::Set(d, bias);
    for (std::size_t word = 0; word < words; ++word) {
        std::uint64_t bits = 0;
        HWY_UNROLL(16)
        for (std::size_t first = 0; first < 64; first += hn::MaxLanes(d), texel += hn::MaxLanes(d)) {
            const auto at = hn::BitCast(di, hn::LoadU(hn::RebindToUnsigned<decltype(d)>{}, texel));
            bits |= std::uint64_t(bitsOfMask(d, hn::Gt(hn::GatherIndex(d, depth, at), biases))) << first;
        }
        shaded[word] = bits;
    }
}

}  // namespace noonmark::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace noonmark {

namespace {

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

NOONMARK_KERNEL(lookUpWords);
void GroundLookup::look(const DepthSlice& slice, std::span<std::uint64_t> shaded) const {
    const std::size_t whole = texel_.size() / 64;
    NOONMARK_CALL(lookUpWords)(slice.depth.data(), texel_.data(), whole, biasM_, shaded.data());
    if (whole < words())
        shaded[whole] = lookUpOneByOne(slice.depth.data(), std::span(texel_).subspan(whole * 64), biasM_);
}

}  // namespace noonmark
#endif
