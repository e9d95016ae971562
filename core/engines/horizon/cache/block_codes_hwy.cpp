#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/engines/horizon/cache/block_codes_hwy.cpp"
#include <hwy/foreach_target.h>

#include "core/engines/horizon/cache/block_codes.h"
#include "core/simd/kernel.h"

HWY_BEFORE_NAMESPACE();
namespace noonmark::HWY_NAMESPACE {
namespace {

constexpr std::size_t side = ReceiverBlocks::side;
using D = LanesUpTo<HorizonCode, side>;
using V = hn::Vec<D>;
constexpr D d;
constexpr std::size_t lanes = hn::MaxLanes(d);

/// Calls visit(row, place) for each vector of a block's cells; place: of its first cell in the row.
template <class Visit>
HWY_INLINE void forEachVector(const Visit& visit) {
    for (std::size_t row = 0; row < side; ++row)
        for (std::size_t place = 0; place < side; place += lanes) visit(row, place);
}

template <class Compare>
HWY_INLINE void findCells(const HorizonCode* a, const HorizonCode* b, const ReceiverBlocks::Masks& masks,
                          ReceiverBlocks::Masks& found, const Compare& compare) {
    for (std::size_t row = 0; row < side; ++row) {
        std::uint32_t cells = 0;
        for (std::size_t place = 0; place < side; place += lanes) {
            const V x = hn::LoadU(d, a + row * side + place), y = hn::LoadU(d, b + row * side + place);
            cells |= bitsOfMask(d, compare(x, y)) << place;
        }
        found[row] = std::uint16_t(cells & masks[row]);
    }
}

/// Eight rows of eight codes.
using Eight = hn::FixedTag<HorizonCode, 8>;
constexpr Eight eight;

// Interleaves rows i and i + 4 into rows 2i and 2i + 1; applied three times this transposes eight rows.
HWY_INLINE void weave(const hn::Vec<Eight>* from, hn::Vec<Eight>* to) {
    HWY_UNROLL(4)
    for (std::size_t i = 0; i < 4; ++i) {
        to[2 * i] = hn::InterleaveLower(eight, from[i], from[i + 4]);
        to[2 * i + 1] = hn::InterleaveUpper(eight, from[i], from[i + 4]);
    }
}

HWY_INLINE void transposeQuarter(const HorizonCode* from, HorizonCode* to) {
    hn::Vec<Eight> a[8], b[8];
    HWY_UNROLL(8)
    for (std::size_t i = 0; i < 8; ++i) a[i] = hn::LoadU(eight, from + i * side);
    weave(a, b);
    weave(b, a);
    weave(a, b);
    HWY_UNROLL(8)
    for (std::size_t i = 0; i < 8; ++i) hn::StoreU(b[i], eight, to + i * side);
}

}  // namespace

HorizonCode findLowest(const HorizonCode* codes, const ReceiverBlocks::Masks& masks) {
    const V highest = hn::Set(d, HorizonCode(steepnessLevels / 2));
    V lowest = highest;
    forEachVector([&](std::size_t row, std::size_t place) HWY_ATTR {
        const V of = hn::LoadU(d, codes + row * side + place);
        lowest =
            hn::Min(lowest, hn::IfThenElse(maskOfBits(d, std::uint32_t(masks[row]) >> place), of, highest));
    });
    alignas(64) HorizonCode each[lanes];
    hn::Store(lowest, d, each);
    HorizonCode minimum = each[0];
    for (const HorizonCode code : each) minimum = code < minimum ? code : minimum;
    return minimum;
}

void setOthers(const ReceiverBlocks::Masks& masks, HorizonCode code, BlockCodes& codes) {
    forEachVector([&](std::size_t row, std::size_t place) HWY_ATTR {
        HorizonCode* const at = codes.values + row * side + place;
        const auto inside = maskOfBits(d, std::uint32_t(masks[row]) >> place);
        hn::Store(hn::IfThenElse(inside, hn::Load(d, at), hn::Set(d, code)), d, at);
    });
}

void transpose(const HorizonCode* from, BlockCodes& to) {
    for (std::size_t row = 0; row < side; row += 8)
        for (std::size_t column = 0; column < side; column += 8)
            transposeQuarter(from + row * side + column, to.values + column * side + row);
}

void raise(const HorizonCode* others, BlockCodes& codes) {
    forEachVector([&](std::size_t row, std::size_t place) HWY_ATTR {
        HorizonCode* const at = codes.values + row * side + place;
        hn::Store(hn::Max(hn::Load(d, at), hn::LoadU(d, others + row * side + place)), d, at);
    });
}

void findDifferences(const HorizonCode* a, const HorizonCode* b, const ReceiverBlocks::Masks& masks,
                     ReceiverBlocks::Masks& differ) {
    findCells(a, b, masks, differ, [](V x, V y) HWY_ATTR { return hn::Ne(x, y); });
}

void findEqual(const HorizonCode* a, const HorizonCode* b, const ReceiverBlocks::Masks& masks,
               ReceiverBlocks::Masks& equal) {
    findCells(a, b, masks, equal,
              [](V x, V y) HWY_ATTR { return hn::And(hn::Eq(x, y), hn::Ne(x, hn::Set(d, noHorizon))); });
}

}  // namespace noonmark::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace noonmark {

NOONMARK_KERNEL(findLowest);
HorizonCode findLowest(const HorizonCode* codes, const ReceiverBlocks::Masks& masks) {
    return NOONMARK_CALL(findLowest)(codes, masks);
}

NOONMARK_KERNEL(setOthers);
void setOthers(const ReceiverBlocks::Masks& masks, HorizonCode code, BlockCodes& codes) {
    NOONMARK_CALL(setOthers)(masks, code, codes);
}

NOONMARK_KERNEL(transpose);
void transpose(const HorizonCode* from, BlockCodes& to) { NOONMARK_CALL(transpose)(from, to); }

NOONMARK_KERNEL(raise);
void raise(const HorizonCode* others, BlockCodes& codes) { NOONMARK_CALL(raise)(others, codes); }

NOONMARK_KERNEL(findDifferences);
void findDifferences(const HorizonCode* a, const HorizonCode* b, const ReceiverBlocks::Masks& masks,
                     ReceiverBlocks::Masks& differ) {
    NOONMARK_CALL(findDifferences)(a, b, masks, differ);
}

NOONMARK_KERNEL(findEqual);
void findEqual(const HorizonCode* a, const HorizonCode* b, const ReceiverBlocks::Masks& masks,
               ReceiverBlocks::Masks& equal) {
    NOONMARK_CALL(findEqual)(a, b, masks, equal);
}

}  // namespace noonmark
#endif
