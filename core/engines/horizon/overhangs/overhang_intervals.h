#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <glm/vec2.hpp>
#include <span>
#include <vector>

#include "core/engines/horizon/overhangs/overhang_visibility.h"

namespace noonmark {

/// The altitudes that overhangs hide from a block at one azimuth. Seen from a cell, a prism hides the
/// altitudes from its far bottom to its near top, and a triangle those between its two intersections with the
/// vertical plane through the sun: exactly those whose ray it would block. Reuses its memory; one per thread.
class OverhangIntervals {
public:
    /// Selects the block. `lowest`: intervals that end below that code hide no sun.
    void begin(const ViewingBlock& from, const BlockAxes& axes, HorizonCode lowest);

    /// Adds a layer for the block's cells whose horizons are no higher than `most`. About 2 ns per cell that
    /// sees it.
    void look(const OverhangLayer& layer, std::span<const OverhangStrip> strips, HorizonCode most);

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
    alignas(64) HorizonCode low_[VisibleCells::most], high_[VisibleCells::most];  // of visible cells
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
