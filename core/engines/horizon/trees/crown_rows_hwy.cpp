#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/engines/horizon/trees/crown_rows_hwy.cpp"
#include <hwy/foreach_target.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "core/engines/horizon/trees/crown_sweep.h"
#include "core/simd/kernel.h"

HWY_BEFORE_NAMESPACE();
namespace noonmark::HWY_NAMESPACE {
namespace {

constexpr std::size_t rowCells = std::size_t(ReceiverBlocks::side);
using RowCells = LanesUpTo<float, 16>;
constexpr RowCells dr;
using RowVector = hn::Vec<RowCells>;
constexpr std::size_t lanes = hn::MaxLanes(dr);
constexpr hn::Rebind<HorizonCode, RowCells> rowCodes;
constexpr hn::RebindToSigned<RowCells> rowWholes;
static_assert(CrownLevels::maximum % lanes == 0 && rowCells % lanes == 0);

HWY_INLINE RowVector every(float value) { return hn::Set(dr, value); }
HWY_INLINE RowVector notBelow0(RowVector value) { return hn::Max(value, hn::Zero(dr)); }

// 1 - e^-x for x >= 0, within 5e-5: the series of e^(-x / 16), to the 16th power.
HWY_INLINE RowVector takenBy(RowVector x) {
    const auto y = hn::Min(hn::Mul(x, every(1.0F / 16)), every(1));
    auto power = hn::Sub(every(0.5F), hn::Mul(y, every(1.0F / 6)));
    power = hn::Sub(every(1), hn::Mul(y, power));
    power = hn::Sub(every(1), hn::Mul(y, power));
    for (int i = 0; i < 4; ++i) power = hn::Mul(power, power);
    return hn::Sub(every(1), power);
}

/// What a crown has for all cells, a number a level. A crown's shadow lies between `nearest` and `farthest`
/// from its axis, along the azimuth; depths are lengths in the units of the shape times inLeaf and bare.
struct CrownTerms {
    alignas(64) float nearest[CrownLevels::maximum], farthest[CrownLevels::maximum];
    alignas(64) float inLeaf[CrownLevels::maximum], bare[CrownLevels::maximum];
    alignas(64) float scale[CrownLevels::maximum], slope[CrownLevels::maximum], offset[CrownLevels::maximum];
};

/// Cells side by side, as a shape looks at them.
struct CellsOfRow {
    RowVector distance, aside, ground;  // of the axis along and across the azimuth; above the datum
};

/// An ellipsoid above all receivers, so that rays have the whole of their chords. A ray passes it at v =
/// (height over its middle at the axis) / scale and u = aside / radius; its path is 2 sqrt(1 - u2 - v2) times
/// one length for all rays of a level.
struct ClearEllipsoid {
    static HWY_INLINE void setTerms(const CrownOnBlock& crown, const CrownLevels& levels,
                                    const CrownGround& ground, CrownTerms& terms) {
        const float half = (crown.topM - crown.bottomM) / 2, middle = (crown.topM + crown.bottomM) / 2;
        const float square = half * half, radius2 = crown.radiusM * crown.radiusM;
        for (std::size_t i = 0; i < levels.count; i += lanes) {
            const auto tan = hn::Load(dr, levels.tan + i), perTan = hn::Load(dr, levels.perTan + i);
            const auto height = hn::Sqrt(hn::Add(every(square), hn::Mul(hn::Mul(tan, tan), every(radius2))));
            const auto scale = hn::Div(every(1), height);
            const auto length =
                hn::Mul(hn::Mul(hn::Load(dr, levels.secant + i), scale), every(2 * crown.radiusM * half));
            hn::Store(hn::Mul(hn::Sub(every(middle - ground.highestM), height), perTan), dr,
                      terms.nearest + i);
            hn::Store(hn::Mul(hn::Add(every(middle - ground.lowestM), height), perTan), dr,
                      terms.farthest + i);
            hn::Store(hn::Mul(length, every(crown.inLeafPerM)), dr, terms.inLeaf + i);
            hn::Store(hn::Mul(length, every(crown.barePerM)), dr, terms.bare + i);
            hn::Store(scale, dr, terms.scale + i);
            hn::Store(hn::Mul(scale, tan), dr, terms.slope + i);
            hn::Store(hn::Mul(scale, every(-middle)), dr, terms.offset + i);
        }
    }

    HWY_INLINE ClearEllipsoid(const CrownOnBlock& crown, const CrownLevels&, const CellsOfRow& cells) {
        const auto u = hn::Mul(cells.aside, every(1 / crown.radiusM));
        withinU_ = hn::Sub(every(1), hn::Mul(u, u));
    }
    HWY_INLINE bool missed() const { return hn::AllFalse(dr, hn::Gt(withinU_, hn::Zero(dr))); }
    HWY_INLINE RowVector length(std::size_t level, const CrownTerms& terms, const CellsOfRow& cells) const {
        const auto v = hn::Add(hn::Add(hn::Mul(cells.distance, every(terms.slope[level])),
                                       hn::Mul(cells.ground, every(terms.scale[level]))),
                               every(terms.offset[level]));
        return hn::Sqrt(notBelow0(hn::Sub(withinU_, hn::Mul(v, v))));
    }

private:
    RowVector withinU_;
};

// For shapes whose length is that along the azimuth.
HWY_INLINE void setLevelTerms(const CrownOnBlock& crown, const CrownLevels& levels, const CrownGround& ground,
                              CrownTerms& terms) {
    for (std::size_t i = 0; i < levels.count; i += lanes) {
        const auto perTan = hn::Load(dr, levels.perTan + i), secant = hn::Load(dr, levels.secant + i);
        const auto first = hn::Mul(every(crown.bottomM - ground.highestM), perTan);
        const auto last = hn::Mul(every(crown.topM - ground.lowestM), perTan);
        hn::Store(hn::Sub(notBelow0(first), every(crown.radiusM)), dr, terms.nearest + i);
        hn::Store(hn::Add(last, every(crown.radiusM)), dr, terms.farthest + i);
        hn::Store(hn::Mul(secant, every(crown.inLeafPerM)), dr, terms.inLeaf + i);
        hn::Store(hn::Mul(secant, every(crown.barePerM)), dr, terms.bare + i);
    }
}

/// A cylinder: rays of all altitudes meet its side at the same two distances.
struct Cylinder {
    static HWY_INLINE void setTerms(const CrownOnBlock& crown, const CrownLevels& levels,
                                    const CrownGround& ground, CrownTerms& terms) {
        setLevelTerms(crown, levels, ground, terms);
    }
    HWY_INLINE Cylinder(const CrownOnBlock& crown, const CrownLevels& levels, const CellsOfRow& cells)
        : levels_(levels) {
        const float radius2 = crown.radiusM * crown.radiusM;
        const auto half = hn::Sqrt(notBelow0(hn::Sub(every(radius2), hn::Mul(cells.aside, cells.aside))));
        near_ = notBelow0(hn::Sub(cells.distance, half));
        far_ = hn::Add(cells.distance, half);
        toBottom_ = hn::Sub(every(crown.bottomM), cells.ground);
        toTop_ = hn::Sub(every(crown.topM), cells.ground);
    }
    HWY_INLINE bool missed() const { return hn::AllFalse(dr, hn::Gt(far_, near_)); }
    HWY_INLINE RowVector length(std::size_t level, const CrownTerms&, const CellsOfRow&) const {
        const auto perTan = every(levels_.perTan[level]);
        const auto low = hn::Max(near_, hn::Mul(toBottom_, perTan));
        return notBelow0(hn::Sub(hn::Min(far_, hn::Mul(toTop_, perTan)), low));
    }

private:
    const CrownLevels& levels_;
    RowVector near_, far_, toBottom_, toTop_;
};

/// A quadric cut by two levels, with receivers inside it, too. With x from the axis away from the cell, u
/// aside and p the ray's height over the pivot there: inside where a (x2 + u2) + q (p + tan x)2 + c <= 0.
struct Quadric {
    static HWY_INLINE void setTerms(const CrownOnBlock& crown, const CrownLevels& levels,
                                    const CrownGround& ground, CrownTerms& terms) {
        setLevelTerms(crown, levels, ground, terms);
    }
    HWY_INLINE Quadric(const CrownOnBlock& crown, const CrownLevels& levels, const CellsOfRow& cells)
        : crown_(crown), levels_(levels) {
        const float heightM = crown.topM - crown.bottomM, radius2 = crown.radiusM * crown.radiusM;
        const bool cone = crown.shape == CrownShape::cone;
        a_ = cone ? 1 : 1 / radius2;
        q_ = cone ? -radius2 / (heightM * heightM) : 4 / (heightM * heightM);
        pivotM_ = cone ? crown.topM : (crown.bottomM + crown.topM) / 2;
        asideTerm_ = hn::Add(every(cone ? 0 : -1), hn::Mul(every(a_), hn::Mul(cells.aside, cells.aside)));
    }
    HWY_INLINE bool missed() const { return false; }
    HWY_INLINE RowVector length(std::size_t level, const CrownTerms&, const CellsOfRow& cells) const {
        const float tan = levels_.tan[level];
        constexpr float minimum = 1e-6F;  // a ray along a cone's side
        float a = a_ + q_ * tan * tan;
        if (std::abs(a) < minimum) a = minimum;
        const float perA = 1 / a, perTan = levels_.perTan[level];
        const auto zero = hn::Zero(dr);
        const auto height = hn::Add(cells.ground, hn::Mul(cells.distance, every(tan)));
        const auto p = hn::Sub(height, every(pivotM_));
        const auto b = hn::Mul(p, every(q_ * tan));
        const auto c = hn::Add(asideTerm_, hn::Mul(every(q_), hn::Mul(p, p)));
        const auto discriminant = hn::Sub(hn::Mul(b, b), hn::Mul(c, every(a)));
        const auto root = hn::Sqrt(notBelow0(discriminant));
        const auto minusB = hn::Sub(zero, b);
        auto far = hn::Mul(hn::Add(minusB, root), every(perA));
        auto near = a > 0 ? hn::Mul(hn::Sub(minusB, root), every(perA)) : every(-1e9F);
        near = hn::Max(near, hn::Mul(hn::Sub(every(crown_.bottomM), height), every(perTan)));
        near = hn::Max(near, hn::Sub(zero, cells.distance));
        far = hn::Min(far, hn::Mul(hn::Sub(every(crown_.topM), height), every(perTan)));
        const auto path = hn::Sub(far, near);
        const auto through = hn::And(hn::Gt(discriminant, zero), hn::Gt(path, zero));
        return hn::IfThenElseZero(through, path);
    }

private:
    const CrownOnBlock& crown_;
    const CrownLevels& levels_;
    float a_, q_, pivotM_;
    RowVector asideTerm_;
};

/// Lowest and highest of the values along a row, which change by so much from cell to cell.
struct RowRange {
    RowRange(float first, float perCell) {
        const float last = first + perCell * float(rowCells - 1);
        low = std::min(first, last);
        high = std::max(first, last);
    }
    float low, high;
};

// Levels at which the shadow reaches cells at such distances.
HWY_INLINE unsigned levelsAt(const CrownTerms& terms, std::size_t count, const RowRange& distance) {
    unsigned bits = 0;
    for (std::size_t i = 0; i < count; i += lanes) {
        const auto meets = hn::And(hn::Lt(hn::Load(dr, terms.nearest + i), every(distance.high)),
                                   hn::Gt(hn::Load(dr, terms.farthest + i), every(distance.low)));
        bits |= bitsOfMask(dr, meets) << i;
    }
    return bits;
}

HWY_INLINE void addDepth(float* to, RowVector length, float depth) {
    hn::Store(hn::Add(hn::Load(dr, to), hn::Mul(length, every(depth))), dr, to);
}

// Levels count from zero where a crown first comes before them.
HWY_INLINE void touchRow(CrownDepths& depths, std::size_t row, unsigned bits) {
    for (unsigned fresh = bits & ~unsigned(depths.touched[row]); fresh != 0; fresh &= fresh - 1) {
        const auto level = std::size_t(std::countr_zero(fresh));
        for (std::size_t cell = 0; cell < rowCells; cell += lanes) {
            hn::Store(hn::Zero(dr), dr, depths.inLeaf[row][level] + cell);
            hn::Store(hn::Zero(dr), dr, depths.bare[row][level] + cell);
        }
    }
    depths.touched[row] = std::uint16_t(depths.touched[row] | bits);
}

template <class Shape>
HWY_INLINE void addToCells(const CrownOnBlock& crown, const CrownLevels& levels, const CrownTerms& terms,
                           const CellsOfRow& cells, unsigned bits, float (*inLeaf)[rowCells],
                           float (*bare)[rowCells], std::size_t cell) {
    const Shape shape(crown, levels, cells);
    if (shape.missed()) return;
    for (; bits != 0; bits &= bits - 1) {
        const auto level = std::size_t(std::countr_zero(bits));
        const auto length = shape.length(level, terms, cells);
        addDepth(inLeaf[level] + cell, length, terms.inLeaf[level]);
        if (levels.bare[level] > 0) addDepth(bare[level] + cell, length, terms.bare[level]);
    }
}

template <class Shape>
HWY_INLINE void addShape(const CrownOnBlock& crown, const CrownLevels& levels, const CrownGround& ground,
                         const std::uint16_t* visible, CrownDepths& depths) {
    CrownTerms terms;
    Shape::setTerms(crown, levels, ground, terms);
    for (std::size_t row = 0; row < rowCells; ++row) {
        const float aside = crown.aside + crown.asidePerRow * float(row);
        const float distance = crown.distance + crown.distancePerRow * float(row);
        const RowRange across(aside, crown.asidePerCell);
        if (visible[row] == 0 || across.low >= crown.radiusM || across.high <= -crown.radiusM) continue;
        const unsigned bits =
            visible[row] & levelsAt(terms, levels.count, RowRange(distance, crown.distancePerCell));
        if (bits == 0) continue;
        touchRow(depths, row, bits);
        for (std::size_t cell = 0; cell < rowCells; cell += lanes) {
            const auto place = hn::Iota(dr, float(cell));
            const CellsOfRow cells{
                hn::Add(every(distance), hn::Mul(place, every(crown.distancePerCell))),
                hn::Add(every(aside), hn::Mul(place, every(crown.asidePerCell))),
                ground.rowsM == nullptr ? hn::Zero(dr) : hn::LoadU(dr, ground.rowsM[row].values + cell)};
            addToCells<Shape>(crown, levels, terms, cells, bits, depths.inLeaf[row], depths.bare[row], cell);
        }
    }
}

}  // namespace

void addCrownToBlock(const CrownOnBlock& crown, const CrownLevels& levels, const CrownGround& ground,
                     const std::uint16_t* visible, CrownDepths& depths) {
    if (crown.shape == CrownShape::cylinder)
        addShape<Cylinder>(crown, levels, ground, visible, depths);
    else if (crown.shape == CrownShape::ellipsoid && crown.bottomM >= ground.highestM)
        addShape<ClearEllipsoid>(crown, levels, ground, visible, depths);
    else
        addShape<Quadric>(crown, levels, ground, visible, depths);
}

void findVisibleLevels(const CrownLevels& levels, const HorizonCode* codes,
                       const ReceiverBlocks::Masks& receivers, std::uint16_t* visible) {
    const auto none = hn::Set(rowWholes, std::numeric_limits<std::int32_t>::max());
    for (std::size_t row = 0; row < rowCells; ++row) {
        auto lowest = none;
        for (std::size_t cell = 0; cell < rowCells; cell += lanes) {
            const auto some = maskOfBits(rowWholes, unsigned(receivers[row]) >> cell);
            const auto here = hn::PromoteTo(rowWholes, hn::LoadU(rowCodes, codes + row * rowCells + cell));
            lowest = hn::Min(lowest, hn::IfThenElse(some, here, none));
        }
        const auto seen = hn::ConvertTo(dr, hn::MinOfLanes(rowWholes, lowest));
        unsigned bits = 0;
        for (std::size_t i = 0; i < levels.count; i += lanes)
            bits |= bitsOfMask(dr, hn::Gt(hn::Load(dr, levels.belowCode + i), seen)) << i;
        visible[row] = std::uint16_t(bits & levels.all());
    }
}

void toShares(const CrownLevels& levels, const std::uint16_t* some, CrownDepths& depths) {
    const auto change = [](float* row) {
        for (std::size_t cell = 0; cell < rowCells; cell += lanes)
            hn::Store(takenBy(hn::Load(dr, row + cell)), dr, row + cell);
    };
    for (std::size_t row = 0; row < rowCells; ++row)
        for (unsigned bits = depths.touched[row] & some[row]; bits != 0; bits &= bits - 1) {
            const auto i = std::size_t(std::countr_zero(bits));
            change(depths.inLeaf[row][i]);
            if (levels.bare[i] > 0) change(depths.bare[row][i]);
        }
}

void weighBlock(const CrownLevels& levels, const CrownDepths& shares, const HorizonCode* codes,
                float fractions, std::int32_t* evergreen, std::int32_t* seasonal) {
    const auto zero = hn::Zero(dr), one = every(1);
    const auto addSteps = [&](RowVector steps, std::int32_t* to) {
        const auto whole = hn::ConvertTo(rowWholes, hn::Add(hn::Mul(steps, every(fractions)), every(0.5F)));
        hn::Store(hn::Add(hn::Load(rowWholes, to), whole), rowWholes, to);
    };
    for (std::size_t row = 0; row < rowCells; ++row) {
        const unsigned touched = shares.touched[row] & levels.weighed;
        if (touched == 0) continue;
        for (std::size_t cell = 0; cell < rowCells; cell += lanes) {
            const std::size_t place = row * rowCells + cell;
            const auto horizons =
                hn::ConvertTo(dr, hn::PromoteTo(rowWholes, hn::LoadU(rowCodes, codes + place)));
            auto all = zero, season = zero;
            for (unsigned bits = touched; bits != 0; bits &= bits - 1) {
                const auto i = std::size_t(std::countr_zero(bits));
                const auto above =
                    hn::Mul(hn::Sub(every(levels.belowCode[i]), horizons), every(levels.perCode[i]));
                const auto seen = hn::Min(hn::Max(above, zero), one);
                const auto taken = hn::Mul(seen, hn::Load(dr, shares.inLeaf[row][i] + cell));
                all = hn::Add(all, hn::Mul(taken, every(levels.inLeaf[i] + levels.bare[i])));
                season = hn::Add(season, hn::Mul(taken, every(levels.inLeaf[i])));
                if (levels.bare[i] == 0) continue;
                const auto takenBare = hn::Mul(seen, hn::Load(dr, shares.bare[row][i] + cell));
                season = hn::Add(season, hn::Mul(takenBare, every(levels.bare[i])));
            }
            addSteps(all, evergreen + place);
            addSteps(season, seasonal + place);
        }
    }
}

namespace {

constexpr hn::RebindToUnsigned<RowCells> rowBits;
using Bits = hn::Vec<decltype(rowBits)>;

HWY_INLINE Bits everyBits(DarkLevels value) { return hn::Set(rowBits, value); }

/// Follows the shares of some cells from one level to the next.
class DarkCells {
public:
    HWY_INLINE explicit DarkCells(float share) : share_(every(share)) {}

    HWY_INLINE void add(std::size_t level, RowVector taken) {
        const auto dark = hn::IfThenElseZero(hn::RebindMask(rowBits, hn::Ge(taken, share_)), everyBits(1));
        if (next_ == 0)
            before_ = dark;
        else
            addChange(hn::Xor(dark, before_), taken);
        for (; next_ < level; ++next_) add(before_);
        add(dark);
        ++next_;
        before_ = dark;
        takenBefore_ = taken;
    }
    [[nodiscard]] HWY_INLINE Bits levels(std::size_t count) {
        for (; next_ < count; ++next_) add(before_);
        return levels_;
    }

private:
    HWY_INLINE void add(Bits dark) { levels_ = hn::Or(levels_, hn::Shl(dark, everyBits(DarkLevels(next_)))); }
    HWY_INLINE void addChange(Bits changed, RowVector taken) {
        constexpr float parts = 1U << bitsOfChange;
        const auto isChanged = hn::Gt(changed, hn::Zero(rowBits));
        const auto rise =
            hn::IfThenElse(hn::RebindMask(dr, isChanged), hn::Sub(taken, takenBefore_), every(1));
        const auto way = hn::Mul(hn::Div(hn::Sub(share_, takenBefore_), rise), every(parts));
        const auto part =
            hn::BitCast(rowBits, hn::ConvertTo(rowWholes, hn::Min(notBelow0(way), every(parts - 1))));
        const auto fits = hn::And(isChanged, hn::Lt(at_, everyBits(32)));
        levels_ = hn::Or(levels_, hn::IfThenElseZero(fits, hn::Shl(part, hn::Min(at_, everyBits(31)))));
        at_ = hn::Add(at_, hn::IfThenElseZero(isChanged, everyBits(bitsOfChange)));
    }

    RowVector share_, takenBefore_ = hn::Zero(dr);
    Bits levels_ = hn::Zero(rowBits), before_ = hn::Zero(rowBits), at_ = everyBits(firstChangeBit);
    std::size_t next_ = 0;
};

// `known`: levels, as bits. Untouched ones take nothing.
template <class OfLevel>
HWY_INLINE bool findDarkCells(unsigned known, unsigned touched, std::size_t count, float share,
                              const OfLevel& sharesOf, DarkLevels* dark) {
    DarkCells cells(share);
    for (unsigned bits = known; bits != 0; bits &= bits - 1) {
        const auto level = std::size_t(std::countr_zero(bits));
        cells.add(level, (touched >> level & 1U) != 0 ? hn::Load(dr, sharesOf(level)) : hn::Zero(dr));
    }
    const auto levels = cells.levels(count);
    hn::Store(levels, rowBits, dark);
    return !hn::AllFalse(rowBits, hn::Gt(levels, hn::Zero(rowBits)));
}

}  // namespace

bool findDark(const CrownLevels& levels, const CrownDepths& shares, const std::uint16_t* computed,
              float share, DarkLevels* inLeaf, DarkLevels* bare, bool& anyBare) {
    unsigned outOfSeason = 0;
    for (std::size_t i = 0; i < levels.count; ++i) outOfSeason |= (levels.bare[i] > 0 ? 1U : 0U) << i;
    bool any = false;
    anyBare = false;
    for (std::size_t row = 0; row < rowCells; ++row) {
        const unsigned touched = shares.touched[row], known = touched == 0 ? 0 : computed[row];
        for (std::size_t cell = 0; cell < rowCells; cell += lanes) {
            const std::size_t place = row * rowCells + cell;
            const auto find = [&](unsigned some, const auto& of, DarkLevels* dark) {
                return findDarkCells(
                    some, touched, levels.count, share,
                    [&](std::size_t level) { return of[row][level] + cell; }, dark + place);
            };
            any = find(known, shares.inLeaf, inLeaf) || any;
            anyBare = find(known & outOfSeason, shares.bare, bare) || anyBare;
        }
    }
    return any;
}

void makeDarkSpan(const CrownLevels& levels, std::size_t span, const HorizonCode* horizons, DarkLevels* dark,
                  DarkSpan& made) {
    const auto lower = int(span == 0 ? 0 : span - 1), upper = int(std::min(span, levels.count - 1));
    const std::int32_t from = levels.meanCode[lower], width = levels.meanCode[upper] - from;
    const auto none = hn::Set(rowWholes, std::numeric_limits<HorizonCode>::max());
    for (std::size_t lane = 0; lane < lanesOfDark; lane += lanes) {
        const auto bits = hn::LoadU(rowBits, dark + lane);
        const auto isDark = [&](int level) {
            const auto bit = everyBits(1U << unsigned(level));
            return hn::RebindMask(rowWholes, hn::Eq(hn::And(bits, bit), bit));
        };
        const auto low = isDark(lower), high = isDark(upper);
        const auto changes = hn::ShiftRight<firstChangeBit>(bits);
        const auto part = hn::BitCast(rowWholes, hn::And(changes, everyBits((1U << bitsOfChange) - 1)));
        const auto halves = hn::Add(hn::Add(part, part), hn::Set(rowWholes, 1));  // the middle of a part
        const auto way = hn::ShiftRight<bitsOfChange + 1>(hn::Mul(halves, hn::Set(rowWholes, width)));
        // Beyond the lower level's own sun.
        const auto reached = hn::Add(hn::Set(rowWholes, from), hn::Max(way, hn::Set(rowWholes, 1)));
        const auto horizon = hn::PromoteTo(rowWholes, hn::LoadU(rowCodes, horizons + lane));
        const auto below =
            hn::IfThenElse(low, hn::IfThenElse(high, none, hn::Max(horizon, reached)), horizon);
        const auto above =
            hn::IfThenElse(hn::AndNot(low, high), hn::Sub(reached, hn::Set(rowWholes, 1)), none);
        hn::Store(hn::DemoteTo(rowCodes, below), rowCodes, made.below + lane);
        hn::Store(hn::DemoteTo(rowCodes, above), rowCodes, made.above + lane);
        // Beyond the four changes that have a place stands the middle.
        constexpr DarkLevels middle = (1U << (bitsOfChange - 1)) << (firstChangeBit - bitsOfChange);
        const auto left = hn::Or(hn::ShiftRight<bitsOfChange>(changes), everyBits(middle));
        const auto rest =
            hn::Or(hn::And(bits, everyBits((1U << firstChangeBit) - 1)), hn::ShiftLeft<firstChangeBit>(left));
        const auto isChanged = hn::RebindMask(rowBits, hn::Xor(low, high));
        hn::StoreU(hn::IfThenElse(isChanged, rest, bits), rowBits, dark + lane);
    }
}

}  // namespace noonmark::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace noonmark {

NOONMARK_KERNEL(addCrownToBlock);
void addCrownToBlock(const CrownOnBlock& crown, const CrownLevels& levels, const CrownGround& ground,
                     const std::uint16_t* visible, CrownDepths& depths) {
    NOONMARK_CALL(addCrownToBlock)(crown, levels, ground, visible, depths);
}

NOONMARK_KERNEL(findVisibleLevels);
void findVisibleLevels(const CrownLevels& levels, const HorizonCode* codes,
                       const ReceiverBlocks::Masks& receivers, std::uint16_t* visible) {
    NOONMARK_CALL(findVisibleLevels)(levels, codes, receivers, visible);
}

NOONMARK_KERNEL(toShares);
void toShares(const CrownLevels& levels, const std::uint16_t* some, CrownDepths& depths) {
    NOONMARK_CALL(toShares)(levels, some, depths);
}

NOONMARK_KERNEL(weighBlock);
void weighBlock(const CrownLevels& levels, const CrownDepths& shares, const HorizonCode* codes,
                float fractions, std::int32_t* evergreen, std::int32_t* seasonal) {
    NOONMARK_CALL(weighBlock)(levels, shares, codes, fractions, evergreen, seasonal);
}

NOONMARK_KERNEL(findDark);
bool findDark(const CrownLevels& levels, const CrownDepths& shares, const std::uint16_t* computed,
              float share, DarkLevels* inLeaf, DarkLevels* bare, bool& anyBare) {
    return NOONMARK_CALL(findDark)(levels, shares, computed, share, inLeaf, bare, anyBare);
}

NOONMARK_KERNEL(makeDarkSpan);
void makeDarkSpan(const CrownLevels& levels, std::size_t span, const HorizonCode* horizons, DarkLevels* dark,
                  DarkSpan& made) {
    NOONMARK_CALL(makeDarkSpan)(levels, span, horizons, dark, made);
}

}  // namespace noonmark
#endif
