#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <glm/vec2.hpp>
#include <limits>
#include <span>
#include <vector>

#include "core/accumulate/horizon/edit_block.h"
#include "core/accumulate/horizon/gaps.h"
#include "core/accumulate/horizon/open_layers.h"
#include "core/accumulate/horizon/receiver_blocks.h"

namespace noonmark {

/// A square of cells as those look who see what hangs from there.
struct OpenSquare {
    static constexpr HorizonCode blind = std::numeric_limits<HorizonCode>::max();  ///< no horizon is as high

    BlockCodes horizons;              ///< row by row; `blind` for cells that do not matter
    const float* groundsM = nullptr;  ///< row by row, above the datum; null: all lie on it
};

/// What hangs, looked at from a square at one azimuth. Seen from a cell each layer hides the altitudes
/// between its two crossings with the vertical plane through the sun: a prism those from its far bottom to
/// its near top, a triangle those between its two crossings: exactly those whose ray it would stop. Keeps its
/// memory; one for each thread.
class OpenLook {
public:
    /// From now on: this square, whose first cell is (column, row). `lowest`: what ends below that code hides
    /// no sun.
    void begin(const ShadowAxes& axes, double alongPerMetre, glm::ivec2 first, HorizonCode lowest);
    [[nodiscard]] OpenSquare& square() { return square_; }

    /// Looks at a layer from the square's cells whose horizons are no higher than `most`. About 3 ns a cell
    /// across which it is seen.
    void look(const OpenLayer& layer, std::span<const OpenStrip> strips, HorizonCode most);

    /// Calls visit(cell, low, high) for the intervals that reach above the horizons, cell by cell (16 x row +
    /// column) in ascending order, from below, disjoint and apart.
    template <class Visit>
    void finish(const Visit& visit);

private:
    static constexpr int side = ReceiverBlocks::side, cells = ReceiverBlocks::cells;
    /// Cells that a layer is seen from, and where: distances and rises of its near and far side.
    struct Seen {
        int count = 0;
        std::array<std::uint8_t, cells> cell;
        alignas(64) std::array<float, cells> toNear, toFar, nearRise, farRise;
        alignas(64) std::array<HorizonCode, cells> low, high;
    };
    /// An interval that begins above the horizon.
    struct Apart {
        int cell;
        HorizonCode low, high;
    };
    /// A strip as the square's first cell sees it.
    struct Side {
        float distance, slope, rise, riseSlope;
    };
    struct Strip {
        float low, high;
        Side near, far;
    };
    void findStrips(std::span<const OpenStrip> strips);
    [[nodiscard]] Side sideFrom(const OpenStrip::Side& of) const;
    void lookAlong(int line, HorizonCode most);
    void see(const Strip& strip, int cell, float width, float along, HorizonCode most);
    void addSeen();
    [[nodiscard]] bool joins(int cell, HorizonCode low) const {
        return int(low) <= std::max(int(square_.horizons.values[cell]) + 1, int(lowest_));
    }
    void raise(int cell, HorizonCode low, HorizonCode high);

    ShadowAxes axes_{{0, 1}};
    float alongPerMetre_ = 1, shift_ = 0;  // `shift`: q falls by so much from line to line
    ShadowAxes::Point first_{};            // of the square's cells
    HorizonCode lowest_ = noHorizon;
    OpenSquare square_;
    std::array<std::uint64_t, cells / 64> raised_{};  // cells, as bits
    std::array<HorizonCode, cells> lows_;             // where what raised them begins
    std::vector<Apart> apart_;
    std::vector<Strip> strips_;  // of the layer at hand that reach into the square
    Seen seen_;
};

template <class Visit>
void OpenLook::finish(const Visit& visit) {
    std::ranges::sort(apart_, [](const Apart& a, const Apart& b) {
        return a.cell != b.cell ? a.cell < b.cell : a.low < b.low;
    });
    // What is apart from the horizon as it was when it came may not be from what that was raised to.
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
            visit(cell, lows_[std::size_t(cell)], square_.horizons.values[cell]);
        }
    visitApart(cells);
}

}  // namespace noonmark
