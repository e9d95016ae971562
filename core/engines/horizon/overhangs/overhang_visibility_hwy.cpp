#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/engines/horizon/overhangs/overhang_visibility_hwy.cpp"
#include <hwy/foreach_target.h>

#include <algorithm>
#include <bit>

#include "core/engines/horizon/overhangs/overhang_intervals.h"
#include "core/simd/kernel.h"

HWY_BEFORE_NAMESPACE();
namespace noonmark::HWY_NAMESPACE {
namespace {

constexpr int side = ReceiverBlocks::side;
constexpr float onOverhangs = 1e-3F;  // in cells; a receiver closer than this is on the overhang
constexpr HorizonCode zenith = HorizonCode(steepnessLevels - 1 + int(noHorizon));

using D = LanesUpTo<float, std::size_t(side)>;
using V = hn::Vec<D>;
using Mask = hn::Mask<D>;
constexpr D d;
constexpr hn::RebindToSigned<D> di;
constexpr hn::Rebind<HorizonCode, D> dc;
constexpr int lanes = int(hn::MaxLanes(d));

/// Neighbouring cells of a row of the block.
struct Cells {
    int first;           // number of the first one, in the block
    V places;            // in the row
    float shift, along;  // of the row (BlockAxes)
};

// Distance of each cell from a side of the strip, and the side's rise above the cell's ground.
HWY_INLINE V distanceTo(const StripLanes::Side& of, int strip, V width, float along) {
    return hn::Sub(hn::Set(d, of.distance[strip] + along), hn::Mul(hn::Set(d, of.slope[strip]), width));
}
HWY_INLINE V riseOf(const StripLanes::Side& of, int strip, V width, V ground) {
    return hn::Sub(hn::Add(hn::Set(d, of.rise[strip]), hn::Mul(hn::Set(d, of.riseSlope[strip]), width)),
                   ground);
}

HWY_INLINE void addCells(const StripLanes& strips, int strip, const Cells& cells, Mask within, V ground,
                         VisibleCells& seen) {
    const V width = hn::Sub(cells.places, hn::Set(d, strips.low[strip] + cells.shift));
    const V toFar = distanceTo(strips.far, strip, width, cells.along);
    const Mask behind = hn::And(within, hn::Gt(toFar, hn::Set(d, onOverhangs)));
    if (hn::AllFalse(d, behind)) return;
    const Packer packer(d, behind);
    const int at = seen.count;
    hn::StoreU(packer.pack(toFar), d, seen.toFar + at);
    hn::StoreU(packer.pack(distanceTo(strips.near, strip, width, cells.along)), d, seen.toNear + at);
    hn::StoreU(packer.pack(riseOf(strips.near, strip, width, ground)), d, seen.nearRise + at);
    hn::StoreU(packer.pack(riseOf(strips.far, strip, width, ground)), d, seen.farRise + at);
    hn::StoreU(packer.pack(hn::Iota(di, cells.first)), di, seen.cell + at);
    seen.count += int(hn::CountTrue(d, behind));
}

// The strips that overlap a row of the block, as bits.
HWY_INLINE std::uint32_t findStrips(const StripLanes& strips, float shift) {
    std::uint32_t found = 0;
    for (int i = 0; i < strips.count; i += lanes) {
        const V low = hn::Add(hn::Load(d, strips.low + i), hn::Set(d, shift)),
                high = hn::Add(hn::Load(d, strips.high + i), hn::Set(d, shift));
        const Mask overlaps = hn::And(hn::Le(low, hn::Set(d, float(side - 1))), hn::Gt(high, hn::Zero(d)));
        found |= bitsOfMask(d, overlaps) << i;
    }
    return found & ((1U << strips.count) - 1);
}

/// Some cells of a row, and which of them may see the layer and belong to no strip yet.
struct OpenCells : Cells {
    Mask left;
    V ground;
};

HWY_INLINE OpenCells openCells(const ViewingBlock& block, int row, int place, const BlockAxes& axes,
                               HorizonCode highest) {
    const int first = row * side + place;
    const auto codes = hn::PromoteTo(di, hn::Load(dc, block.horizons.values + first));
    const Mask low = hn::RebindMask(d, hn::Lt(codes, hn::Set(di, highest + 1)));
    const V ground = block.groundsM == nullptr
                         ? hn::Zero(d)
                         : hn::Mul(hn::LoadU(d, block.groundsM + first), hn::Set(d, axes.alongPerMetre));
    return {{first, hn::Iota(d, float(place)), axes.shift * float(row), axes.sign * float(row)}, low, ground};
}

HWY_INLINE void addStrip(const StripLanes& strips, int strip, OpenCells& cells, VisibleCells& seen) {
    const Mask from = hn::Le(hn::Set(d, strips.low[strip] + cells.shift), cells.places),
               to = hn::Gt(hn::Set(d, strips.high[strip] + cells.shift), cells.places);
    const Mask within = hn::And(hn::And(from, to), cells.left);
    if (hn::AllFalse(d, within)) return;
    addCells(strips, strip, cells, within, cells.ground, seen);
    cells.left = hn::AndNot(within, cells.left);
}

HWY_INLINE void addRow(const StripLanes& strips, const ViewingBlock& block, int row, const BlockAxes& axes,
                       HorizonCode highest, VisibleCells& seen) {
    std::uint32_t found = findStrips(strips, axes.shift * float(row));
    if (found == 0) return;
    OpenCells cells[side / lanes];
    for (int part = 0; part < side / lanes; ++part)
        cells[part] = openCells(block, row, part * lanes, axes, highest);
    for (; found != 0; found &= found - 1)
        for (OpenCells& some : cells) addStrip(strips, std::countr_zero(found), some, seen);
}

HWY_INLINE auto codesOfRise(V rise, V distance) {
    const V level = hn::Mul(hn::Div(rise, hn::Add(rise, distance)), hn::Set(d, float(steepnessLevels)));
    const auto code = hn::Add(hn::ConvertTo(di, hn::Min(level, hn::Set(d, float(steepnessLevels - 1)))),
                              hn::Set(di, std::int32_t{noHorizon}));
    return hn::IfThenElse(hn::RebindMask(di, hn::Gt(rise, hn::Zero(d))), code,
                          hn::Set(di, std::int32_t{noHorizon}));
}

}  // namespace

void addVisibleCells(const StripLanes& strips, const ViewingBlock& block, const BlockAxes& axes,
                     HorizonCode highest, VisibleCells& seen) {
    for (int row = 0; row < side; ++row) addRow(strips, block, row, axes, highest, seen);
}

// If the near side lies behind the cell, the cell is below or above the overhang; an overhang above it hides
// everything up to the zenith.
void findIntervals(const VisibleCells& seen, bool solid, HorizonCode* low, HorizonCode* high) {
    const V zero = hn::Zero(d);
    for (int i = 0; i < seen.count; i += lanes) {
        const V toNear = hn::Load(d, seen.toNear + i), toFar = hn::Load(d, seen.toFar + i),
                near = hn::Load(d, seen.nearRise + i), far = hn::Load(d, seen.farRise + i);
        const V over = solid ? far : hn::Sub(hn::Mul(near, toFar), hn::Mul(far, toNear));
        const auto behind =
            hn::IfThenElse(hn::RebindMask(di, hn::Gt(over, zero)), hn::Set(di, std::int32_t{zenith}),
                           hn::Set(di, std::int32_t{noHorizon}));
        const Mask before = hn::Gt(toNear, zero);
        const auto ahead = codesOfRise(near, hn::IfThenElse(before, toNear, hn::Set(d, 1)));
        const auto atNear = hn::IfThenElse(hn::RebindMask(di, before), ahead, behind),
                   atFar = codesOfRise(far, toFar);
        hn::Store(hn::DemoteTo(dc, hn::Min(atNear, atFar)), dc, low + i);
        hn::Store(hn::DemoteTo(dc, hn::Max(atNear, atFar)), dc, high + i);
    }
}

}  // namespace noonmark::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace noonmark {

void StripLanes::add(const OverhangStrip& strip, const BlockAxes& axes) {
    constexpr int side = ReceiverBlocks::side;
    const float all = -axes.shift * float(side - 1), lowest = std::min(0.0F, all) - 1,
                highest = std::max(0.0F, all) + float(side);
    const auto from = float(strip.lowQ - axes.q), to = float(strip.highQ - axes.q);
    if (from > highest || to < lowest) return;
    low[count] = from;
    high[count] = to;
    const auto set = [&](Side& side16, const OverhangStrip::Side& of) {
        side16.distance[count] = float(axes.along - of.along);
        side16.slope[count] = float(of.slope);
        side16.rise[count] = float(of.rise);
        side16.riseSlope[count] = float(of.riseSlope);
    };
    set(near, strip.near);
    set(far, strip.far);
    ++count;
}

NOONMARK_KERNEL(addVisibleCells);
void addVisibleCells(const StripLanes& strips, const ViewingBlock& block, const BlockAxes& axes,
                     HorizonCode highest, VisibleCells& seen) {
    NOONMARK_CALL(addVisibleCells)(strips, block, axes, highest, seen);
}

NOONMARK_KERNEL(findIntervals);
void findIntervals(const VisibleCells& seen, bool solid, HorizonCode* low, HorizonCode* high) {
    NOONMARK_CALL(findIntervals)(seen, solid, low, high);
}

}  // namespace noonmark
#endif
