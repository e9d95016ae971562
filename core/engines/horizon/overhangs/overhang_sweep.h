#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <stop_token>
#include <vector>

#include "core/engines/horizon/geometry/shadow_axes.h"
#include "core/engines/horizon/overhangs/gaps.h"
#include "core/engines/horizon/overhangs/overhang_intervals.h"
#include "core/engines/horizon/overhangs/overhang_tile.h"

namespace noonmark {

/// What is looked at from the cells of a tile, at one azimuth.
struct OverhangView {
    std::span<const OverhangShapes* const> shapes;
    const OverhangTile& tile;
    glm::dvec2 away;
    HorizonCode lowest;  ///< code of the lowest sun: what ends below hides none
    double cellM;
    ShadowExtent within = everywhere;  ///< cells that matter

    static constexpr ShadowExtent everywhere{-1e300, 1e300, -1e300, 1e300};
};

/// What hides the sun at one azimuth without standing on the ground like a wall. Keeps its memory from one
/// view to the next; one for each thread.
class OverhangSweep {
public:
    static constexpr HorizonCode blind = ViewingBlock::blind;

    /// From now on: this view, whose tile and shapes must outlive what follows. Blocks from which nothing
    /// can be seen, whatever their horizons, are found here; some 50 ns a layer (OverhangLayers).
    void begin(const OverhangView& view, const std::stop_token& stop);

    /// Whether something may be seen from a block of the tile (OverhangTile::blockNumbers) whose lowest
    /// horizon that matters is this.
    [[nodiscard]] bool maySee(std::size_t block, HorizonCode lowest) const;
    /// Looks from there, and calls visit as OverhangIntervals::finish() does. Some 0.1 us a layer that may be
    /// seen.
    template <class Visit>
    void look(std::size_t block, const ViewingBlock& from, HorizonCode lowest, const Visit& visit);

    /// `horizons`: of what stands, one a number; `blind` for those that do not matter. Returns the intervals
    /// that reach above them, receiver by receiver in ascending order, from below, disjoint and apart; none
    /// once stopped. Valid until the next call. Cost: of begin(), and of look() for all blockNumbers.
    std::span<const Gap> intervals(const OverhangView& view, std::span<const HorizonCode> horizons,
                                   const std::stop_token& stop);

private:
    /// A layer that may be seen from a block, and how high at most.
    struct Entry {
        std::uint32_t layer;
        std::int32_t next;  // of the block's
        HorizonCode most;
    };
    struct Range {
        double low, high;
    };
    void findBlocks(std::uint32_t layer, const OverhangLayer& of, double lowestTan);
    void addBlocks(std::uint32_t layer, int line, const Range& across, HorizonCode most);
    [[nodiscard]] HorizonCode lowestIn(std::size_t block, std::span<const HorizonCode> horizons) const;
    [[nodiscard]] ViewingBlock blockAt(std::size_t block, std::span<const HorizonCode> horizons);
    [[nodiscard]] std::size_t columns() const;
    [[nodiscard]] glm::ivec2 firstOf(std::size_t block) const;
    [[nodiscard]] BlockAxes axesOf(std::size_t block) const;

    std::optional<OverhangView> view_;
    ShadowAxes axes_{{0, 1}};
    double alongPerMetre_ = 0;
    OverhangLayers layers_;
    std::vector<Entry> entries_;
    std::vector<std::int32_t> firsts_;  // entry of each block; -1: none
    OverhangIntervals look_;
    std::array<std::int32_t, ReceiverBlocks::cells> numbers_{};  // of the block at hand, -1: none
    std::array<float, ReceiverBlocks::cells> groundsM_{};
    std::vector<Gap> gaps_;
};

template <class Visit>
void OverhangSweep::look(std::size_t block, const ViewingBlock& from, HorizonCode lowest,
                         const Visit& visit) {
    look_.begin(from, axesOf(block), view_->lowest);
    for (std::int32_t i = firsts_[block]; i >= 0; i = entries_[std::size_t(i)].next) {
        const Entry& entry = entries_[std::size_t(i)];
        if (entry.most < lowest) continue;
        const OverhangLayer& layer = layers_.all()[entry.layer];
        look_.look(layer, layers_.of(layer), entry.most);
    }
    look_.finish(visit);
}

}  // namespace noonmark
