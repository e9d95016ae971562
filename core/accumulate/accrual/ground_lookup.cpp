#include "core/accumulate/accrual/ground_lookup.h"

#include <algorithm>
#include <cmath>

#include "core/accumulate/horizon/lanes16.h"

namespace noonmark {

namespace {

constexpr Ints16 laneBit{1,      1 << 1, 1 << 2,  1 << 3,  1 << 4,  1 << 5,  1 << 6,  1 << 7,
                         1 << 8, 1 << 9, 1 << 10, 1 << 11, 1 << 12, 1 << 13, 1 << 14, 1 << 15};
constexpr Ints16 counting{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15};

[[gnu::always_inline]] inline std::uint64_t sixteen(const float* depth, const std::uint32_t* texel,
                                                    const Floats16& bias) {
    Floats16 found;
    for (int lane = 0; lane < 16; ++lane) found[lane] = depth[texel[lane]];
    Ints16 bits = found > bias ? laneBit : Ints16{};
    for (int apart = 8; apart > 0; apart /= 2) bits |= __builtin_shuffle(bits, counting ^ apart);
    return std::uint64_t(std::uint32_t(bits[0]));
}

NOONMARK_EVERY_ISA
void lookUp(const float* depth, const std::uint32_t* texel, std::size_t words, float bias,
            std::uint64_t* shaded) {
    const Floats16 biases = Floats16{} + bias;
    for (std::size_t word = 0; word < words; ++word, texel += 64)
        shaded[word] = sixteen(depth, texel, biases) | sixteen(depth, texel + 16, biases) << 16U |
                       sixteen(depth, texel + 32, biases) << 32U | sixteen(depth, texel + 48, biases) << 48U;
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
