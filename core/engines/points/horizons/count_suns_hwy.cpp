#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/engines/points/horizons/count_suns_hwy.cpp"
#include <hwy/foreach_target.h>

#include <limits>

#include "core/engines/points/horizons/horizon_of_point.h"
#include "core/simd/kernel.h"

HWY_BEFORE_NAMESPACE();
namespace noonmark::HWY_NAMESPACE {
namespace {

constexpr std::size_t blockSize = SunBins::blockSize;
using Tans = LanesUpTo<float, blockSize>;
using Counts = LanesUpTo<std::uint16_t, blockSize>;

/// How many of a block's tangents are up to `tan`, or below it.
template <bool inclusive>
HWY_INLINE std::size_t countInBlock(const float* block, float tan) {
    constexpr Tans d;
    const auto limit = hn::Set(d, tan);
    std::size_t sum = 0;
    for (std::size_t i = 0; i < blockSize; i += hn::Lanes(d)) {
        const auto tans = hn::LoadU(d, block + i);
        sum += hn::CountTrue(d, inclusive ? hn::Le(tans, limit) : hn::Lt(tans, limit));
    }
    return sum;
}

/// How many suns of the bin are up to `tan`, or below it; `tan` is finite.
template <bool inclusive>
HWY_INLINE std::size_t countInBin(const SunBins& suns, const SunBins::Bin& bin, float tan) {
    std::size_t blocks = 0, found = blockSize;
    for (std::size_t at = bin.firstLast; found == blockSize; at += blockSize) {
        found = countInBlock<inclusive>(&suns.lastOfBlock[at], tan);
        blocks += found;
    }
    const std::size_t first = blocks * blockSize;
    return first + countInBlock<inclusive>(&suns.tans[bin.firstTan + first], tan);
}

/// Sums of rows of SunBins::above.
class MonthSums {
public:
    /// `maximum`: no entry of the row is larger, below 65536.
    HWY_INLINE void add(const std::uint16_t* row, std::uint32_t maximum) {
        if (inShort_ + maximum > std::numeric_limits<std::uint16_t>::max()) flush();
        inShort_ += maximum;
        for (std::size_t i = 0; i < blockSize; i += hn::Lanes(d))
            hn::Store(hn::Add(hn::Load(d, short_ + i), hn::LoadU(d, row + i)), d, short_ + i);
    }
    HWY_INLINE const SunBins::Months& total() {
        flush();
        return sums_;
    }

private:
    void flush() {
        for (std::size_t month = 0; month < SunBins::months; ++month) sums_[month] += short_[month];
        for (std::uint16_t& sum : short_) sum = 0;
        inShort_ = 0;
    }

    static constexpr Counts d{};
    HWY_ALIGN std::uint16_t short_[blockSize] = {};
    std::uint32_t inShort_ = 0;
    SunBins::Months sums_{};
};

}  // namespace

SunBins::Months countSunlit(const SunBins& suns, const BinHorizon& horizon) {
    MonthSums lit, fromGaps, aboveGaps;
    const auto rowOf = [&](const SunBins::Bin& bin, std::size_t after) {
        return &suns.above[(bin.firstRow + after) * SunBins::months];
    };
    for (std::size_t k = 0; k < SunBins::count; ++k) {
        const float tan = horizon.tan[k];
        if (tan == BinDirections::always) continue;
        const SunBins::Bin& bin = suns.bins[k];
        lit.add(rowOf(bin, countInBin<true>(suns, bin, tan)), bin.suns);
        for (std::uint32_t i = horizon.firstGap[k]; i < horizon.firstGap[k + 1]; ++i) {
            const auto low = float(horizon.gaps[i].lowTan), high = float(horizon.gaps[i].highTan);
            fromGaps.add(rowOf(bin, countInBin<false>(suns, bin, low)), bin.suns);
            if (high >= bin.highestTan) continue;
            aboveGaps.add(rowOf(bin, countInBin<true>(suns, bin, high)), bin.suns);
        }
    }
    SunBins::Months months = lit.total();
    for (std::size_t month = 0; month < SunBins::months; ++month)
        months[month] += aboveGaps.total()[month] - fromGaps.total()[month];
    return months;
}

}  // namespace noonmark::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace noonmark {
NOONMARK_KERNEL(countSunlit);
SunBins::Months countSunlit(const SunBins& suns, const BinHorizon& horizon) {
    return NOONMARK_CALL(countSunlit)(suns, horizon);
}
}  // namespace noonmark
#endif
