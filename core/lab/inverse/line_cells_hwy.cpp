#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/lab/inverse/line_cells_hwy.cpp"
#include <hwy/foreach_target.h>

#include <algorithm>

#include "core/lab/inverse/shadow_lines.h"
#include "core/simd/kernel.h"

HWY_BEFORE_NAMESPACE();
namespace noonmark::HWY_NAMESPACE {
namespace {

using D = LanesUpTo<float, Lanes::perBlock>;
using DI = hn::RebindToSigned<D>;
using Ints = hn::Vec<DI>;
constexpr D d;
constexpr DI di;
constexpr int lanes = int(hn::MaxLanes(d));

/// The entries of the step table for some neighbouring cells, as RunEnd::entry().
struct Entries {
    alignas(64) std::int32_t of[std::size_t(lanes)];

    HWY_INLINE Entries(const RunEnd& end, int cell) {
        const auto one = hn::Set(d, 1), place = hn::ConvertTo(d, hn::Iota(di, cell));
        const auto at = hn::Add(hn::Set(d, end.start), hn::Mul(place, hn::Set(d, end.perCell)));
        const auto held = hn::Min(at, hn::Set(d, float(StepTable::size + 1)));
        const auto entry = hn::Add(hn::IfThenElse(hn::Lt(at, hn::Zero(d)), hn::Neg(one), held), one);
        hn::Store(hn::ConvertTo(di, entry), di, of);
    }
};

// Calls change(first, count) for the cells [i, end), as many at a time as a vector has lanes; afterwards i is
// behind the last.
template <class Change>
HWY_INLINE void forCells(int& i, int end, const Change& change) {
    while (i < end) {
        const int count = std::min(lanes, end - i);
        change(i, count);
        i += count;
    }
}

}  // namespace

// Where the rear is behind at all steps or the front ahead, no lookup is needed.
void shadePart(const ShadowMask* before, const SweepPart& part, const CellRange& cells, ShadowMask* row) {
    const RunEnd rear = part.rear, front = part.front;
    const ShadowMask all = before[StepTable::size + 2];
    const int rearTo = part.rearBehindFrom, frontFrom = part.frontAheadTo;
    const int end = std::min(part.end, cells.end);
    int i = std::max(part.first, cells.first);
    const auto behindFront = [&](int first, int count) HWY_ATTR {
        const Entries at(rear, first);
        for (int k = 0; k < count; ++k) row[first + k] |= before[at.of[k]];
    };
    const auto between = [&](int first, int count) HWY_ATTR {
        const Entries from(rear, first), to(front, first);
        for (int k = 0; k < count; ++k) row[first + k] |= before[from.of[k]] & ~before[to.of[k]];
    };
    const auto beforeRear = [&](int first, int count) HWY_ATTR {
        const Entries to(front, first);
        for (int k = 0; k < count; ++k) row[first + k] |= all & ~before[to.of[k]];
    };
    forCells(i, std::min({rearTo, frontFrom, end}), behindFront);
    for (; i < std::min(frontFrom, end); ++i) row[i] |= all;
    forCells(i, std::min(rearTo, end), between);
    forCells(i, end, beforeRear);
}

void markLanes(const SourceLines& lines, int places, const RunRule& rule, std::uint16_t* changed) {
    const auto steepest = hn::Set(d, rule.steepestM);
    const auto lowest = hn::Set(
        d, std::max(-rule.steepestM, 0.9999F * RunRule::foldedBy / std::max(rule.cellsPerMetre, 1e-9F)));
    for (int at = 1; at < places; ++at) {
        std::uint32_t bits = 0;
        for (int first = 0; first < Lanes::perBlock; first += lanes) {
            // The sign bit of `beyond` is set where a value that must not be negative is.
            Ints other = hn::Zero(di), beyond = other;
            for (int level = 0; level < lines.levels; ++level) {
                const std::ptrdiff_t now = at * lines.step + level, before = now - lines.step;
                const auto higher = hn::Sub(hn::Load(d, lines.heightM[now].values + first),
                                            hn::Load(d, lines.heightM[before].values + first));
                const hn::RebindToUnsigned<D> du;
                other = hn::Or(other,
                               hn::BitCast(di, hn::Xor(hn::Load(du, lines.building[now].values + first),
                                                       hn::Load(du, lines.building[before].values + first))));
                beyond = hn::Or(beyond,
                                hn::BitCast(di, hn::Or(hn::Sub(steepest, higher), hn::Sub(higher, lowest))));
            }
            const auto zero = hn::Zero(di);
            bits |= bitsOfMask(di, hn::Or(hn::Ne(other, zero), hn::Lt(beyond, zero))) << first;
        }
        changed[at] = std::uint16_t(bits);
    }
}

}  // namespace noonmark::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace noonmark {

NOONMARK_KERNEL(shadePart);
void shadeCells(const ShadowMask* before, const SweepPart& part, const CellRange& cells, ShadowMask* row) {
    NOONMARK_CALL(shadePart)(before, part, cells, row);
}

NOONMARK_KERNEL(markLanes);
void markChanges(const SourceLines& lines, int places, const RunRule& rule, std::uint16_t* changed) {
    NOONMARK_CALL(markLanes)(lines, places, rule, changed);
}

}  // namespace noonmark
#endif
