#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/engines/horizon/sweep/raise_block_hwy.cpp"
#include <hwy/foreach_target.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/engines/horizon/sweep/raise_block.h"
#include "core/simd/kernel.h"

HWY_BEFORE_NAMESPACE();
namespace noonmark::HWY_NAMESPACE {
namespace {

constexpr std::size_t side = ReceiverBlocks::side;
using D = LanesUpTo<float, side>;
using V = hn::Vec<D>;
constexpr D d;
constexpr std::size_t lanes = hn::MaxLanes(d), parts = side / lanes;

// The horizons of a tile of the block stay in registers while all walls pass: this many rows of one vector.
constexpr std::size_t rowsTogether = HWY_TARGET == HWY_SSE4 || HWY_TARGET == HWY_AVX2 ? 8 : 16;
constexpr std::size_t tiles = side / rowsTogether * parts;

/// Values of a wall that are constant within a row of the block, for all rows.
struct WallBeforeRows {
    alignas(64) std::uint32_t cells[side];    // cells behind the wall, as bits; ignore bits from 16 up
    alignas(64) float minusCotAtFirst[side];  // minus the cotangent of the horizon at the row's first cell
    float minusLess, nearest;                 // minus the change of the cotangent per cell; see WallOnBlock
    bool ahead;
};

/// Some of the walls, and for each tile those that shade cells of it.
struct WallGroup {
    static constexpr std::size_t maximum = 32;
    WallBeforeRows walls[maximum];
    std::uint8_t ofTile[tiles][maximum];
    std::size_t count[tiles];
};

constexpr std::size_t tileOf(std::size_t row, std::size_t part) { return row / rowsTogether * parts + part; }

// Index of the first cell of each row whose q is not below this one: 0 to 16.
HWY_INLINE auto placeFrom(V q) {
    const V place = hn::Min(hn::Max(hn::Ceil(hn::Neg(q)), hn::Zero(d)), hn::Set(d, float(side)));
    return hn::BitCast(hn::RebindToUnsigned<D>{}, hn::ConvertTo(hn::RebindToSigned<D>{}, place));
}

HWY_INLINE void findRowsBehind(const WallOnBlock& wall, const BlockRows& rows, WallBeforeRows& before) {
    const hn::RebindToUnsigned<D> du;
    const auto whole = hn::Set(du, 0xFFFFU);
    for (std::size_t row = 0; row < side; row += lanes) {
        const V shifts = hn::LoadU(d, &rows.shifts[row]);
        const V low = hn::Sub(hn::Set(d, wall.low), shifts), high = hn::Sub(hn::Set(d, wall.high), shifts);
        hn::Store(hn::AndNot(hn::Shl(whole, placeFrom(high)), hn::Shl(whole, placeFrom(low))), du,
                  before.cells + row);
        const V along = hn::Add(hn::Set(d, wall.along), hn::LoadU(d, &rows.alongs[row]));
        const V distance = hn::Sub(along, hn::Mul(hn::Set(d, wall.slope), low));
        hn::Store(hn::Mul(distance, hn::Set(d, -wall.perRise)), d, before.minusCotAtFirst + row);
    }
    before.minusLess = -(wall.slope * wall.perRise);
    before.nearest = wall.nearest * wall.perRise;
    before.ahead = wall.ahead;
}

HWY_INLINE void addTo(WallGroup& group, std::size_t wall) {
    if constexpr (tiles == 1) {
        group.ofTile[0][wall] = std::uint8_t(wall);
        group.count[0] = wall + 1;
        return;
    }
    const hn::RebindToUnsigned<D> du;
    constexpr std::uint32_t part0 = (1U << lanes) - 1;
    for (std::size_t row = 0; row < side; row += rowsTogether) {
        auto cells = hn::Load(du, group.walls[wall].cells + row);
        for (std::size_t more = lanes; more < rowsTogether; more += lanes)
            cells = hn::Or(cells, hn::Load(du, group.walls[wall].cells + row + more));
        for (std::size_t part = 0; part < parts; ++part) {
            const std::size_t tile = tileOf(row, part);
            const bool any =
                !hn::AllTrue(du, hn::Eq(hn::And(cells, hn::Set(du, part0 << (part * lanes))), hn::Zero(du)));
            group.ofTile[tile][group.count[tile]] = std::uint8_t(wall);
            group.count[tile] += std::size_t(any);
        }
    }
}

/// Finds the cells of a row, of one vector, among the bits of WallBeforeRows.
class RowCells {
public:
    HWY_INLINE explicit RowCells(std::size_t part)
        : bits_(hn::Shl(hn::Set(du, 1U), hn::Iota(du, std::uint32_t(part * lanes)))) {}
    HWY_INLINE hn::Mask<D> in(const std::uint32_t& cells) const {
        if constexpr (lanes == side)
            return hn::LoadMaskBits(d, reinterpret_cast<const std::uint8_t*>(&cells));
        return hn::RebindMask(d, hn::TestBit(hn::Set(du, cells), bits_));
    }

private:
    static constexpr hn::RebindToUnsigned<D> du{};
    hn::Vec<hn::RebindToUnsigned<D>> bits_;
};

// All cells are farther behind the wall than `nearest` and than 0.
HWY_INLINE void raiseAhead(const WallBeforeRows& wall, std::size_t firstRow, V minusLess,
                           const RowCells& cells, V* horizons) {
    HWY_UNROLL(16)
    for (std::size_t i = 0; i < rowsTogether; ++i) {
        const V cot = hn::Sub(minusLess, hn::Set(d, wall.minusCotAtFirst[firstRow + i]));
        horizons[i] =
            hn::IfThenElse(cells.in(wall.cells[firstRow + i]), hn::Min(horizons[i], cot), horizons[i]);
    }
}

HWY_INLINE void raiseBeside(const WallBeforeRows& wall, std::size_t firstRow, V minusLess,
                            const RowCells& cells, V* horizons) {
    const V nearest = hn::Set(d, wall.nearest);
    HWY_UNROLL(16)
    for (std::size_t i = 0; i < rowsTogether; ++i) {
        const V cot = hn::Sub(minusLess, hn::Set(d, wall.minusCotAtFirst[firstRow + i]));
        const auto shaded = hn::And(cells.in(wall.cells[firstRow + i]), hn::Gt(cot, nearest));
        horizons[i] = hn::IfThenElse(shaded, hn::Min(horizons[i], hn::Max(cot, hn::Zero(d))), horizons[i]);
    }
}

HWY_INLINE void raiseTile(const WallGroup& group, std::size_t firstRow, std::size_t part,
                          BlockHorizons& block) {
    const std::size_t tile = tileOf(firstRow, part), firstPlace = part * lanes;
    const V places = hn::Iota(d, float(firstPlace));
    const RowCells cells(part);
    V horizons[rowsTogether];
    HWY_UNROLL(16)
    for (std::size_t i = 0; i < rowsTogether; ++i)
        horizons[i] = hn::Load(d, block.rows[firstRow + i].values + firstPlace);
    for (std::size_t n = 0; n < group.count[tile]; ++n) {
        // Otherwise GCC computes an address for each row beforehand, and spills them.
        const WallBeforeRows& wall = *forgetOrigin(&group.walls[group.ofTile[tile][n]]);
        const V minusLess = hn::Mul(hn::Set(d, wall.minusLess), places);
        if (wall.ahead)
            raiseAhead(wall, firstRow, minusLess, cells, horizons);
        else
            raiseBeside(wall, firstRow, minusLess, cells, horizons);
    }
    HWY_UNROLL(16)
    for (std::size_t i = 0; i < rowsTogether; ++i)
        hn::Store(horizons[i], d, block.rows[firstRow + i].values + firstPlace);
}

void raiseGroup(std::span<const WallOnBlock> walls, const BlockRows& rows, BlockHorizons& horizons) {
    WallGroup group;
    std::fill_n(group.count, tiles, std::size_t{0});
    for (std::size_t i = 0; i < walls.size(); ++i) {
        findRowsBehind(walls[i], rows, group.walls[i]);
        addTo(group, i);
    }
    for (std::size_t row = 0; row < side; row += rowsTogether)
        for (std::size_t part = 0; part < parts; ++part) raiseTile(group, row, part, horizons);
}

float findLowest(const BlockHorizons& horizons) {
    V lowest = hn::Load(d, horizons.rows[0].values);
    for (const CacheLine<float>& row : horizons.rows)
        for (std::size_t place = 0; place < side; place += lanes)
            lowest = hn::Max(lowest, hn::Load(d, row.values + place));
    return hn::GetLane(hn::MaxOfLanes(d, lowest));
}

}  // namespace

float raiseBlock(std::span<const WallOnBlock> walls, const BlockRows& rows, BlockHorizons& horizons) {
    for (std::size_t first = 0; first < walls.size(); first += WallGroup::maximum)
        raiseGroup(walls.subspan(first, std::min(WallGroup::maximum, walls.size() - first)), rows, horizons);
    return findLowest(horizons);
}

void clearBlock(const ReceiverBlocks::Masks& masks, BlockHorizons& horizons) {
    const V level = hn::Set(d, std::numeric_limits<float>::infinity()),
            others = hn::Set(d, BlockHorizons::notReceiver);
    for (std::size_t row = 0; row < side; ++row)
        for (std::size_t place = 0; place < side; place += lanes)
            hn::Store(hn::IfThenElse(maskOfBits(d, std::uint32_t(masks[row]) >> place), level, others), d,
                      horizons.rows[row].values + place);
}

void toCodes(const BlockHorizons& horizons, HorizonCode lowest, HorizonCode* codes) {
    const hn::RebindToSigned<D> di;
    const hn::Rebind<HorizonCode, D> dc;
    const V levels = hn::Set(d, float(steepnessLevels)), maximum = hn::Set(d, float(steepnessLevels - 1));
    const auto none = hn::Set(di, std::int32_t{noHorizon}), minimum = hn::Set(di, std::int32_t{lowest});
    for (const CacheLine<float>& row : horizons.rows)
        for (std::size_t place = 0; place < side; place += lanes, codes += lanes) {
            const V cot = hn::Load(d, row.values + place);
            const V level = hn::Min(hn::Div(levels, hn::Add(hn::Set(d, 1), cot)), maximum);
            const auto code = hn::Add(hn::ConvertTo(di, level), none);
            const auto shown = hn::And(hn::RebindMask(di, hn::Ge(cot, hn::Zero(d))), hn::Gt(code, minimum));
            hn::Store(hn::DemoteTo(dc, hn::IfThenElse(shown, code, none)), dc, codes);
        }
}

}  // namespace noonmark::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace noonmark {

BlockRows::BlockRows(double k, double sign) : rowsPerQ(k == 0 ? 0 : float(sign / k)) {
    for (int row = 0; row < ReceiverBlocks::side; ++row) {
        shifts[std::size_t(row)] = float(k * sign * row);
        alongs[std::size_t(row)] = float(sign * row);
    }
}

RowRange findRows(const WallOnBlock& wall, const BlockRows& rows) {
    if (rows.rowsPerQ == 0) return {0, ReceiverBlocks::side};
    constexpr float roundingQ = 1e-5F;  // spans many rows if shadows run almost along the rows
    const float margin = 1 + roundingQ * std::abs(rows.rowsPerQ);
    const float a = wall.high * rows.rowsPerQ,
                b = (wall.low + float(ReceiverBlocks::side - 1)) * rows.rowsPerQ;
    return {int(std::clamp(std::min(a, b) - margin, 0.0F, float(ReceiverBlocks::side))),
            int(std::clamp(std::max(a, b) + margin + 1, 0.0F, float(ReceiverBlocks::side)))};
}

NOONMARK_KERNEL(raiseBlock);
float raiseBlock(std::span<const WallOnBlock> walls, const BlockRows& rows, BlockHorizons& horizons) {
    return NOONMARK_CALL(raiseBlock)(walls, rows, horizons);
}

NOONMARK_KERNEL(clearBlock);
void clearBlock(const ReceiverBlocks::Masks& masks, BlockHorizons& horizons) {
    NOONMARK_CALL(clearBlock)(masks, horizons);
}

NOONMARK_KERNEL(toCodes);
void toCodes(const BlockHorizons& horizons, HorizonCode lowest, HorizonCode* codes) {
    NOONMARK_CALL(toCodes)(horizons, lowest, codes);
}

}  // namespace noonmark
#endif
