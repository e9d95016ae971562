#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/engines/points/horizons/hidden_suns_hwy.cpp"
#include <hwy/foreach_target.h>

#include "core/engines/points/horizons/sun_track.h"
#include "core/simd/kernel.h"

HWY_BEFORE_NAMESPACE();
namespace noonmark::HWY_NAMESPACE {
namespace {

using D = LanesUpTo<float, 16>;
constexpr D d;
constexpr hn::RebindToSigned<D> indices;
constexpr std::size_t lanes = hn::MaxLanes(d);

}  // namespace

void classifyPackets(const SunPackets& packets, const RangeBounds& bounds, PacketBits& bits) {
    constexpr std::size_t wordBits = 64;
    for (std::size_t word = 0; word < bits.hidden.size(); ++word) {
        std::uint64_t hidden = 0, lit = 0;
        const std::size_t end = std::min(packets.window.size(), (word + 1) * wordBits);
        for (std::size_t i = word * wordBits; i < end; i += lanes) {
            const auto window = hn::LoadU(indices, &packets.window[i]);
            const auto low = hn::GatherIndex(d, bounds.low.data(), window);
            const auto high = hn::GatherIndex(d, bounds.high.data(), window);
            const auto allHidden = hn::Le(hn::LoadU(d, &packets.highestTan[i]), low);
            const auto allLit = hn::Gt(hn::LoadU(d, &packets.lowestTan[i]), high);
            hidden |= std::uint64_t(bitsOfMask(d, allHidden)) << (i % wordBits);
            lit |= std::uint64_t(bitsOfMask(d, allLit)) << (i % wordBits);
        }
        bits.hidden[word] = hidden;
        bits.lit[word] = lit;
    }
}

std::uint32_t sunsUpTo(const SunPackets& packets, std::size_t first, const BinTangents& tangents) {
    std::uint32_t bits = 0;
    for (std::size_t k = 0; k < SunPackets::size; k += lanes) {
        const hn::Rebind<std::uint16_t, D> narrow;
        const auto bin = hn::PromoteTo(indices, hn::LoadU(narrow, &packets.bin[first + k]));
        const auto limit = hn::GatherIndex(d, tangents.data(), bin);
        bits |= bitsOfMask(d, hn::Le(hn::LoadU(d, &packets.tan[first + k]), limit)) << k;
    }
    return bits;
}

}  // namespace noonmark::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace noonmark {
NOONMARK_KERNEL(classifyPackets);
NOONMARK_KERNEL(sunsUpTo);
void classifyPackets(const SunPackets& packets, const RangeBounds& bounds, PacketBits& bits) {
    NOONMARK_CALL(classifyPackets)(packets, bounds, bits);
}
std::uint32_t sunsUpTo(const SunPackets& packets, std::size_t first, const BinTangents& tangents) {
    return NOONMARK_CALL(sunsUpTo)(packets, first, tangents);
}
}  // namespace noonmark
#endif
