#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <stop_token>
#include <vector>

#include "core/accumulate/horizon/gaps.h"
#include "core/accumulate/horizon/open_look.h"
#include "core/accumulate/horizon/receiver_blocks.h"
#include "core/accumulate/horizon/shadow_axes.h"

namespace noonmark {

/// The cells of a tile that have numbers.
struct OpenTile {
    TileBox box;
    std::vector<std::int32_t> numbers;  ///< row by row; -1: none
    std::vector<float> groundsM;        ///< of each number, above the datum; empty: all lie on it
    std::vector<Stretch> squares;       ///< numbers of each square of cells (ReceiverBlocks), row by row

    OpenTile() = default;
    OpenTile(const Receivers& receivers, const ReceiverBlocks& blocks, double datumM);
};

/// What is looked at from the cells of a tile, at one azimuth.
struct OpenView {
    std::span<const OpenShapes* const> shapes;
    const OpenTile& tile;
    glm::dvec2 away;
    HorizonCode lowest;  ///< code of the lowest sun: what ends below hides none
    double cellM;
    ShadowExtent within = everywhere;  ///< cells that matter

    static constexpr ShadowExtent everywhere{-1e300, 1e300, -1e300, 1e300};
};

/// What hides the sun at one azimuth without standing on the ground like a wall. Keeps its memory from one
/// view to the next; one for each thread.
class OpenSweep {
public:
    static constexpr HorizonCode blind = OpenSquare::blind;

    /// `horizons`: of what stands, one a number; `blind` for those that do not matter. Returns the intervals
    /// that reach above them, receiver by receiver in ascending order, from below, disjoint and apart; none
    /// once stopped. Valid until the next call. Squares are passed over from whose horizons nothing can be
    /// seen; some 5 ns a layer (OpenLayers) and shaded cell of the others.
    std::span<const Gap> intervals(const OpenView& view, std::span<const HorizonCode> horizons,
                                   const std::stop_token& stop);

private:
    /// A layer that may be seen from a square, and how high at most.
    struct Entry {
        std::uint32_t layer;
        std::int32_t next;  // of the square's
        HorizonCode most;
    };
    struct Range {
        double low, high;
    };
    void findSquares(std::uint32_t layer, const OpenLayer& of, double lowestTan);
    void addSquares(std::uint32_t layer, int line, const Range& across, HorizonCode most);
    void look(std::size_t square);
    [[nodiscard]] HorizonCode lowestIn(std::size_t square) const;
    void begin(std::size_t square);
    void finish();
    [[nodiscard]] std::size_t columns() const;

    const OpenView* view_ = nullptr;
    ShadowAxes axes_{{0, 1}};
    double alongPerMetre_ = 0;
    std::span<const HorizonCode> horizons_;
    OpenLayers layers_;
    std::vector<Entry> entries_;
    std::vector<std::int32_t> firsts_;  // entry of each square; -1: none
    OpenLook look_;
    std::array<std::int32_t, ReceiverBlocks::cells> numbers_{};  // of the square at hand, -1: none
    std::array<float, ReceiverBlocks::cells> groundsM_{};
    std::vector<Gap> gaps_;
};

}  // namespace noonmark
