#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/engines/horizon/counting/sun_table_hwy.cpp"
#include <hwy/foreach_target.h>

#include <hwy/cache_control.h>

#include "core/engines/horizon/counting/sun_change.h"
#include "core/simd/kernel.h"

HWY_BEFORE_NAMESPACE();
namespace noonmark::HWY_NAMESPACE {
namespace {

constexpr std::size_t side = ReceiverBlocks::side;
constexpr std::size_t ahead = 512;  // prefetch distance, in horizons

/// Vectors of codes, and of half as many 32-bit integers.
using Codes = hn::ScalableTag<HorizonCode>;
using Indices = hn::Repartition<std::int32_t, Codes>;
constexpr Codes dc;
constexpr hn::RebindToUnsigned<Codes> du;
constexpr Indices di;
constexpr std::size_t lanes = hn::MaxLanes(dc);

/// counts[place] for 32-bit places. A load takes a count's neighbour along, in its upper half.
template <class D>
HWY_INLINE hn::Vec<D> lookUp(D d, const std::int16_t* counts, hn::Vec<D> places) {
    const auto* const base = reinterpret_cast<const std::int32_t*>(counts);
    const auto both = hn::GatherOffset(d, base, hn::ShiftLeft<1>(places));
    return hn::ShiftRight<16>(hn::ShiftLeft<16>(both));
}

// The counts of a vector of places in the table.
HWY_INLINE hn::Vec<Codes> lookUpAll(const std::int16_t* counts, hn::Vec<decltype(du)> places) {
    const hn::Half<decltype(du)> half;
    const auto lower =
        hn::BitCast(di, hn::PromoteTo(hn::RebindToUnsigned<Indices>{}, hn::LowerHalf(half, places)));
    const auto upper =
        hn::BitCast(di, hn::PromoteTo(hn::RebindToUnsigned<Indices>{}, hn::UpperHalf(half, places)));
    const hn::Half<Codes> few;
    return hn::Combine(dc, hn::DemoteTo(few, lookUp(di, counts, upper)),
                       hn::DemoteTo(few, lookUp(di, counts, lower)));
}

// Adds the counts of a vector of horizons.
HWY_INLINE void addVector(const SunTable& table, const HorizonCode* horizons, std::int16_t* sums) {
    const auto unsign = hn::Set(du, std::uint16_t{0x8000}), last = hn::Set(du, std::uint16_t(table.last)),
               lowest = hn::Set(du, std::uint16_t(table.lowest - noHorizon));
    const auto level = hn::Xor(hn::BitCast(du, hn::LoadU(dc, horizons)), unsign);
    const auto places = hn::Min(hn::SaturatedSub(level, lowest), last);
    const auto none = hn::Eq(places, hn::Zero(du)), all = hn::Eq(places, last);
    if (hn::AllTrue(du, none)) return;
    const auto sum = hn::LoadU(dc, sums);
    if (hn::AllTrue(du, hn::Or(none, all))) {
        const auto more = hn::IfThenElseZero(hn::RebindMask(dc, all), hn::Set(dc, table.counts[table.last]));
        hn::StoreU(hn::Add(sum, more), dc, sums);
    } else {
        hn::StoreU(hn::Add(sum, lookUpAll(table.counts, places)), dc, sums);
    }
}

/// Some cells of a row of a block.
using Cells = LanesUpTo<std::int32_t, side>;
constexpr Cells cells;

HWY_INLINE hn::Vec<Cells> countsOf(const SunTable& table, const HorizonCode* horizons) {
    const auto codes = hn::PromoteTo(cells, hn::LoadU(hn::Rebind<HorizonCode, Cells>{}, horizons));
    const auto level = hn::Sub(codes, hn::Set(cells, table.lowest));
    return lookUp(cells, table.counts, hn::Min(hn::Max(level, hn::Zero(cells)), hn::Set(cells, table.last)));
}

// Returns whether a sum has changed.
HWY_INLINE bool addRow(const SunTable& table, const HorizonCode* before, const HorizonCode* after,
                       std::uint32_t mask, std::uint32_t* sums) {
    constexpr hn::RebindToUnsigned<Cells> dsum;
    bool any = false;
    for (std::size_t i = 0; i < side; i += hn::MaxLanes(cells)) {
        const auto less = countsOf(table, before + i), more = countsOf(table, after + i);
        const auto changed = hn::And(hn::Ne(more, less), maskOfBits(cells, mask >> i));
        if (hn::AllFalse(cells, changed)) continue;
        const auto change = hn::IfThenElseZero(changed, hn::Sub(more, less));
        hn::StoreU(hn::Add(hn::LoadU(dsum, sums + i), hn::BitCast(dsum, change)), dsum, sums + i);
        any = true;
    }
    return any;
}

}  // namespace

void addCounts(const SunTable& table, const HorizonCode* horizons, std::size_t count, std::int16_t* sums) {
    std::size_t i = 0;
    for (; i + lanes <= count; i += lanes) {
        hwy::Prefetch(horizons + i + ahead);
        addVector(table, horizons + i, sums + i);
    }
    for (; i < count; ++i) sums[i] = std::int16_t(sums[i] + table.of(horizons[i]));
}

std::uint16_t addDifferences(const SunTable& table, const HorizonCode* before, const HorizonCode* after,
                             const ReceiverBlocks::Masks& masks, std::uint32_t* sums) {
    std::uint32_t rows = 0;
    for (std::size_t row = 0; row < side; ++row) {
        const std::size_t first = row * side;
        if (masks[row] != 0 && addRow(table, before + first, after + first, masks[row], sums + first))
            rows |= 1U << row;
    }
    return std::uint16_t(rows);
}

}  // namespace noonmark::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace noonmark {

NOONMARK_KERNEL(addCounts);
void addCounts(const SunTable& table, const HorizonCode* horizons, std::size_t count, std::int16_t* sums) {
    NOONMARK_CALL(addCounts)(table, horizons, count, sums);
}

NOONMARK_KERNEL(addDifferences);
std::uint16_t addDifferences(const SunTable& table, const HorizonCode* before, const HorizonCode* after,
                             const ReceiverBlocks::Masks& masks, std::uint32_t* sums) {
    return NOONMARK_CALL(addDifferences)(table, before, after, masks, sums);
}

}  // namespace noonmark
#endif
