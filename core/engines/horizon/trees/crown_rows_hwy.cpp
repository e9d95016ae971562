#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/engines/horizon/trees/crown_rows_hwy.cpp"
#include <hwy/foreach_target.h>

#include <cmath>

#include "core/engines/horizon/trees/crown_sweep.h"
#include "core/simd/kernel.h"

HWY_BEFORE_NAMESPACE();
namespace noonmark::HWY_NAMESPACE {
namespace {

constexpr std::size_t rowCells = std::size_t(ReceiverBlocks::side);
using RowCells = LanesUpTo<float, 16>;
constexpr RowCells dr;
using RowVector = hn::Vec<RowCells>;
constexpr hn::Rebind<HorizonCode, RowCells> rowCodes;
constexpr hn::RebindToSigned<RowCells> rowWholes;

HWY_INLINE RowVector every(float value) { return hn::Set(dr, value); }

// e^-x for x >= 0: 2^-n from the exponent's bits, the rest by its series, within 2e-7.
HWY_INLINE RowVector expOfMinus(RowVector x) {
    const auto bounded = hn::Min(x, every(80));
    const auto n = hn::ConvertTo(rowWholes, hn::Add(hn::Mul(bounded, every(1.44269504F)), every(0.5F)));
    const auto whole = hn::ConvertTo(dr, n);
    const auto rest = hn::Sub(hn::Sub(hn::Mul(whole, every(0.693145752F)), bounded),
                              hn::Mul(whole, every(-1.42860677e-6F)));
    auto sum = every(1.0F / 720);
    for (const float term : {1.0F / 120, 1.0F / 24, 1.0F / 6, 0.5F, 1.0F, 1.0F})
        sum = hn::Add(hn::Mul(sum, rest), every(term));
    const auto power = hn::BitCast(dr, hn::ShiftLeft<23>(hn::Sub(hn::Set(rowWholes, 127), n)));
    return hn::Mul(sum, power);
}

/// What a level has in common for all cells.
struct LevelOfCrown {
    LevelOfCrown(const CrownOnRow& crown, const CrownLevel& level)
        : tan(level.tan),
          secant(level.secant),
          perTan(1 / level.tan),
          a(crown.a + crown.q * level.tan * level.tan) {
        constexpr float least = 1e-6F;  // a ray along a cone's side
        if (std::abs(a) < least) a = least;
        perA = 1 / a;
    }
    float tan, secant, perTan, a, perA;
};

// Metres of the cells' rays through the crown.
HWY_INLINE RowVector pathThrough(const CrownOnRow& crown, const LevelOfCrown& level, RowVector distance,
                                 RowVector asideTerm, RowVector ground) {
    const auto height = hn::Add(ground, hn::Mul(distance, every(level.tan)));
    const auto p = hn::Sub(height, every(crown.pivotM));
    const auto b = hn::Mul(p, every(crown.q * level.tan));
    const auto c = hn::Add(asideTerm, hn::Mul(every(crown.q), hn::Mul(p, p)));
    const auto discriminant = hn::Sub(hn::Mul(b, b), hn::Mul(c, every(level.a)));
    const auto zero = hn::Zero(dr);
    const auto root = hn::Sqrt(hn::IfThenElse(hn::Gt(discriminant, zero), discriminant, zero));
    const auto minusB = hn::Sub(zero, b);
    auto far = hn::Mul(hn::Add(minusB, root), every(level.perA));
    auto near = level.a > 0 ? hn::Mul(hn::Sub(minusB, root), every(level.perA)) : every(-1e9F);
    near = hn::Max(near, hn::Mul(hn::Sub(every(crown.bottomM), height), every(level.perTan)));
    near = hn::Max(near, hn::Sub(zero, distance));
    far = hn::Min(far, hn::Mul(hn::Sub(every(crown.topM), height), every(level.perTan)));
    const auto path = hn::Mul(hn::Sub(far, near), every(level.secant));
    const auto through = hn::And(hn::Gt(discriminant, zero), hn::Gt(path, zero));
    return hn::IfThenElse(through, path, zero);
}

HWY_INLINE void addDepth(float* to, RowVector path, float perMetre) {
    hn::StoreU(hn::Add(hn::LoadU(dr, to), hn::Mul(path, every(perMetre))), dr, to);
}

}  // namespace

void addCrownToRow(const CrownOnRow& crown, std::span<const CrownLevel> levels, float* inLeaf, float* bare) {
    for (std::size_t cell = 0; cell < rowCells; cell += hn::MaxLanes(dr)) {
        const auto place = hn::Iota(dr, float(cell));
        const auto distance = hn::Add(every(crown.distance), hn::Mul(place, every(crown.distanceStep)));
        const auto aside = hn::Add(every(crown.aside), hn::Mul(place, every(crown.asideStep)));
        const auto asideTerm = hn::Add(every(crown.c), hn::Mul(every(crown.a), hn::Mul(aside, aside)));
        const auto ground = crown.groundM == nullptr ? hn::Zero(dr) : hn::LoadU(dr, crown.groundM + cell);
        for (std::size_t i = 0; i < levels.size(); ++i) {
            const LevelOfCrown level(crown, levels[i]);
            const auto path = pathThrough(crown, level, distance, asideTerm, ground);
            addDepth(inLeaf + i * rowCells + cell, path, crown.inLeafPerM);
            addDepth(bare + i * rowCells + cell, path, crown.barePerM);
        }
    }
}

void weighRow(std::span<const CrownLevel> levels, const float* inLeaf, const float* bare,
              const HorizonCode* horizons, float* evergreen, float* seasonal) {
    for (std::size_t cell = 0; cell < rowCells; cell += hn::MaxLanes(dr)) {
        const auto codes = hn::ConvertTo(dr, hn::PromoteTo(rowWholes, hn::LoadU(rowCodes, horizons + cell)));
        auto all = hn::Zero(dr), season = hn::Zero(dr);
        const auto one = every(1);
        for (std::size_t i = 0; i < levels.size(); ++i) {
            const CrownLevel& level = levels[i];
            const auto above = hn::Mul(hn::Sub(every(level.belowCode), codes), every(level.perCode));
            const auto visible = hn::Min(hn::Max(above, hn::Zero(dr)), one);
            const auto taken = hn::Sub(one, expOfMinus(hn::LoadU(dr, inLeaf + i * rowCells + cell)));
            const auto takenBare = hn::Sub(one, expOfMinus(hn::LoadU(dr, bare + i * rowCells + cell)));
            const auto leaf = hn::Mul(hn::Mul(visible, every(level.inLeaf)), taken);
            all = hn::Add(all, hn::Mul(hn::Mul(visible, every(level.inLeaf + level.bare)), taken));
            season = hn::Add(season, hn::Add(leaf, hn::Mul(hn::Mul(visible, every(level.bare)), takenBare)));
        }
        hn::StoreU(all, dr, evergreen + cell);
        hn::StoreU(season, dr, seasonal + cell);
    }
}

}  // namespace noonmark::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace noonmark {

NOONMARK_KERNEL(addCrownToRow);
void addCrownToRow(const CrownOnRow& crown, std::span<const CrownLevel> levels, float* inLeaf, float* bare) {
    NOONMARK_CALL(addCrownToRow)(crown, levels, inLeaf, bare);
}

NOONMARK_KERNEL(weighRow);
void weighRow(std::span<const CrownLevel> levels, const float* inLeaf, const float* bare,
              const HorizonCode* horizons, float* evergreen, float* seasonal) {
    NOONMARK_CALL(weighRow)(levels, inLeaf, bare, horizons, evergreen, seasonal);
}

}  // namespace noonmark
#endif
