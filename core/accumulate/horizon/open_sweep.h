#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <stop_token>
#include <vector>

#include "core/accumulate/horizon/gaps.h"
#include "core/accumulate/horizon/open_look.h"
#include "core/accumulate/horizon/open_tile.h"
#include "core/accumulate/horizon/shadow_axes.h"

namespace noonmark {

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

    /// From now on: this view, whose tile and shapes must outlive what follows. Squares from which nothing
    /// can be seen, whatever their horizons, are found here; some 50 ns a layer (OpenLayers).
    void begin(const OpenView& view, const std::stop_token& stop);

    /// Whether something may be seen from a square of the tile (OpenTile::squares) whose lowest horizon that
    /// matters is this.
    [[nodiscard]] bool maySee(std::size_t square, HorizonCode lowest) const;
    /// Looks from there, and calls visit as OpenLook::finish() does. Some 0.1 us a layer that may be seen.
    template <class Visit>
    void look(std::size_t square, const OpenSquare& from, HorizonCode lowest, const Visit& visit);

    /// `horizons`: of what stands, one a number; `blind` for those that do not matter. Returns the intervals
    /// that reach above them, receiver by receiver in ascending order, from below, disjoint and apart; none
    /// once stopped. Valid until the next call. Cost: of begin(), and of look() for all squares.
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
    [[nodiscard]] HorizonCode lowestIn(std::size_t square, std::span<const HorizonCode> horizons) const;
    [[nodiscard]] OpenSquare squareAt(std::size_t square, std::span<const HorizonCode> horizons);
    [[nodiscard]] std::size_t columns() const;
    [[nodiscard]] glm::ivec2 firstOf(std::size_t square) const;
    [[nodiscard]] SquareAxes axesOf(std::size_t square) const;

    std::optional<OpenView> view_;
    ShadowAxes axes_{{0, 1}};
    double alongPerMetre_ = 0;
    OpenLayers layers_;
    std::vector<Entry> entries_;
    std::vector<std::int32_t> firsts_;  // entry of each square; -1: none
    OpenLook look_;
    std::array<std::int32_t, ReceiverBlocks::cells> numbers_{};  // of the square at hand, -1: none
    std::array<float, ReceiverBlocks::cells> groundsM_{};
    std::vector<Gap> gaps_;
};

template <class Visit>
void OpenSweep::look(std::size_t square, const OpenSquare& from, HorizonCode lowest, const Visit& visit) {
    look_.begin(from, axesOf(square), view_->lowest);
    for (std::int32_t i = firsts_[square]; i >= 0; i = entries_[std::size_t(i)].next) {
        const Entry& entry = entries_[std::size_t(i)];
        if (entry.most < lowest) continue;
        const OpenLayer& layer = layers_.all()[entry.layer];
        look_.look(layer, layers_.of(layer), entry.most);
    }
    look_.finish(visit);
}

}  // namespace noonmark
