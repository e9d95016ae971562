#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <glm/vec2.hpp>
#include <limits>
#include <span>
#include <vector>

#include "core/engines/horizon/cache/block_codes.h"
#include "core/engines/horizon/geometry/azimuth_bins.h"
#include "core/engines/horizon/geometry/receiver_blocks.h"
#include "core/engines/horizon/overhangs/overhang_layers.h"

namespace noonmark {

/// An interval of sun codes that are hidden although they lie above the receiver's horizon: low <= code <
/// high.
struct Gap {
    std::uint32_t number;  ///< of the receiver
    HorizonCode low, high;
};

/// Sorts by number, and by altitude within a receiver.
inline void sortByNumber(std::span<Gap> gaps) {
    std::ranges::sort(gaps, [](const Gap& a, const Gap& b) {
        return a.number != b.number ? a.number < b.number : a.low < b.low;
    });
}

/// Calls visit(own) with the gaps of each receiver that has any. `gaps`: sorted by number.
template <class T, class Visit>
void forEachReceiver(std::span<const T> gaps, const Visit& visit) {
    for (std::size_t first = 0, end = 0; first < gaps.size(); first = end) {
        while (end < gaps.size() && gaps[end].number == gaps[first].number) ++end;
        visit(gaps.subspan(first, end - first));
    }
}

struct EveryGap {
    constexpr bool operator()(const auto& /*gap*/) const { return true; }
};

/// Calls visit(gap, from) for each gap that extends above the horizon and all earlier gaps: it adds the
/// levels [from, gap.high). A gap that begins one level above the end of another interval is treated as
/// adjoining it, since only rounding separates them. `gaps`: of one receiver, sorted by altitude, possibly
/// overlapping; elements may have more fields than Gap. Gaps that are not `wanted` are skipped.
template <class Gaps, class Visit, class Wanted = EveryGap>
void forEachAdded(HorizonCode horizon, const Gaps& gaps, const Visit& visit, const Wanted& wanted = {}) {
    HorizonCode hidden = horizon;
    for (const auto& gap : gaps) {
        if (!wanted(gap) || gap.high <= hidden) continue;
        visit(gap, int(gap.low) <= int(hidden) + 1 ? hidden : gap.low);
        hidden = gap.high;
    }
}

/// How many suns the gaps hide above the horizon. `hiddenBelow(code)`: number of suns below this code.
template <class Gaps, class HiddenBelow>
std::uint32_t countHidden(HorizonCode horizon, const Gaps& gaps, const HiddenBelow& hiddenBelow) {
    std::uint32_t hidden = 0;
    forEachAdded(horizon, gaps, [&](const auto& gap, HorizonCode from) {
        hidden += hiddenBelow(gap.high) - hiddenBelow(from);
    });
    return hidden;
}

/// A block of cells from which overhangs are seen, row by row (column by column if shadows run along x).
struct ViewingBlock {
    static constexpr HorizonCode blind = std::numeric_limits<HorizonCode>::max();  ///< above any horizon

    BlockCodes horizons;              ///< `blind` for irrelevant cells
    const float* groundsM = nullptr;  ///< above the datum; null: all at the datum
};

/// Position of a block at one azimuth.
struct BlockAxes {
    double q, along;      ///< of its first cell
    float shift;          ///< decrease of q per row
    float sign;           ///< increase of `along` per row
    float alongPerMetre;  ///< cells along per metre of distance
};

/// Strips of a layer (OverhangStrip) relative to the block's first cell, as a structure of arrays.
struct StripLanes {
    static constexpr int maximum = 16;
    int count = 0;
    alignas(64) float low[maximum], high[maximum];  ///< q
    /// Values at `low` and their change per q.
    struct Side {
        alignas(64) float distance[maximum], slope[maximum], rise[maximum], riseSlope[maximum];
    };
    Side near, far;

    /// Adds the strip if it overlaps the block.
    void add(const OverhangStrip& strip, const BlockAxes& axes);
};

/// Cells that see a layer, with the distances and rises of its near and far side.
struct VisibleCells {
    static constexpr int maximum = ReceiverBlocks::cells, room = maximum + 16;
    int count = 0;
    alignas(64) std::int32_t cell[room];
    alignas(64) float toNear[room], toFar[room], nearRise[room], farRise[room];
};

/// Adds the cells within lowQ <= q < highQ of a strip that lie behind its far side and whose horizons are no
/// higher than `highest`. Strips must ascend; those that share a corner divide the cells there between them.
/// From 5 ns per row.
void addVisibleCells(const StripLanes& strips, const ViewingBlock& block, const BlockAxes& axes,
                     HorizonCode highest, VisibleCells& seen);

/// The altitudes that a layer hides from each of these cells: codes of its lower and upper end, with room for
/// VisibleCells::maximum. `solid`: the layer's far side is its upper one.
void findIntervals(const VisibleCells& seen, bool solid, HorizonCode* low, HorizonCode* high);

/// The altitudes that overhangs hide from a block at one azimuth. Seen from a cell, a prism hides the
/// altitudes from its far bottom to its near top, and a triangle those between its two intersections with the
/// vertical plane through the sun: exactly those whose ray it would block. Reuses its memory; one per thread.
class OverhangIntervals {
public:
    /// Selects the block. `lowest`: intervals that end below that code hide no sun.
    void begin(const ViewingBlock& from, const BlockAxes& axes, HorizonCode lowest);

    /// Adds a layer for the block's cells whose horizons are no higher than `maximum`. About 2 ns per cell
    /// that sees it.
    void look(const OverhangLayer& layer, std::span<const OverhangStrip> strips, HorizonCode maximum);

    /// Calls visit(cell, low, high) for the intervals that reach above the horizons. Cells (16 x row +
    /// position) ascend; the intervals of a cell ascend, are disjoint and do not touch.
    template <class Visit>
    void finish(const Visit& visit);

private:
    static constexpr int cells = ReceiverBlocks::cells;
    /// An interval that begins above the horizon.
    struct Apart {
        int cell;
        HorizonCode low, high;
    };
    void add(bool solid);
    [[nodiscard]] bool joins(int cell, HorizonCode low) const {
        return int(low) <= std::max(int(block_.horizons.values[cell]) + 1, int(lowest_));
    }
    void raise(int cell, HorizonCode low, HorizonCode high);

    BlockAxes axes_{};
    HorizonCode lowest_ = noHorizon;
    ViewingBlock block_;
    std::array<std::uint64_t, cells / 64> raised_{};  // cells with raised horizons, as bits
    std::array<HorizonCode, cells> lows_;             // where the interval that raised a cell begins
    std::vector<Apart> apart_;
    StripLanes strips_;
    VisibleCells seen_;
    alignas(64) HorizonCode low_[VisibleCells::maximum], high_[VisibleCells::maximum];  // of visible cells
};

template <class Visit>
void OverhangIntervals::finish(const Visit& visit) {
    std::ranges::sort(apart_, [](const Apart& a, const Apart& b) {
        return a.cell != b.cell ? a.cell < b.cell : a.low < b.low;
    });
    // An interval that was separate from the horizon when it was added may touch the horizon after it was
    // raised.
    std::erase_if(apart_, [&](const Apart& one) {
        if (!joins(one.cell, one.low)) return false;
        raise(one.cell, one.low, one.high);
        return true;
    });
    auto next = apart_.begin();
    const auto visitApart = [&](int end) {
        while (next != apart_.end() && next->cell < end) {
            Apart whole = *next++;
            for (; next != apart_.end() && next->cell == whole.cell && int(next->low) <= int(whole.high) + 1;
                 ++next)
                whole.high = std::max(whole.high, next->high);
            visit(whole.cell, whole.low, whole.high);
        }
    };
    for (int word = 0; word < int(raised_.size()); ++word)
        for (std::uint64_t bits = raised_[std::size_t(word)]; bits != 0; bits &= bits - 1) {
            const int cell = 64 * word + std::countr_zero(bits);
            visitApart(cell);
            visit(cell, lows_[std::size_t(cell)], block_.horizons.values[cell]);
        }
    visitApart(cells);
}

}  // namespace noonmark
