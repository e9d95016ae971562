#pragma once

// Overhangs: parts of buildings with open air below, which hide an interval of altitudes rather than all
// below a horizon. overhang_layers.h converts them to prisms and triangles and cuts these into strips in the
// axes of one azimuth; overhang_intervals.h finds the cells of a block that see a strip and the altitudes it
// hides from each, joins these with the horizon, and holds the hidden intervals that do not begin at the
// horizon (gaps). OverhangSweep (this file) applies this to the blocks of a tile at one azimuth,
// BatchOverhangs (this file) to a batch during a sweep.

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <stop_token>
#include <vector>

#include "core/engines/horizon/geometry/azimuth_batch.h"
#include "core/engines/horizon/geometry/azimuth_bins.h"
#include "core/engines/horizon/geometry/receiver_blocks.h"
#include "core/engines/horizon/geometry/shadow_axes.h"
#include "core/engines/horizon/overhangs/overhang_intervals.h"

namespace noonmark {

/// The numbered cells of a tile.
struct OverhangTile {
    TileBox box;
    std::vector<std::int32_t> numbers;      ///< of the cells of each block that has any, row by row; -1: none
    std::vector<float> groundsM;            ///< one per number, above the datum; empty: all are at the datum
    std::vector<NumberRange> blockNumbers;  ///< numbers of each block of cells (ReceiverBlocks), row by row
    std::vector<std::int32_t>
        firstOfBlock;  ///< of each of these: place of its first cell in `numbers`; -1: none

    /// Index of a block among all of the tile.
    [[nodiscard]] std::size_t indexOf(const ReceiverBlocks::Block& block) const {
        constexpr int side = ReceiverBlocks::side;
        const int columns = (box.columns + side - 1) / side;
        return std::size_t((block.row - box.firstRow) / side) * std::size_t(columns) +
               std::size_t((block.column - box.firstColumn) / side);
    }
    /// Number of a block's cell 16 x row + column.
    [[nodiscard]] std::uint32_t numberOf(const ReceiverBlocks::Block& block, int cell) const {
        return std::uint32_t(numbers[std::size_t(firstOfBlock[indexOf(block)] + cell)]);
    }

    OverhangTile() = default;
    OverhangTile(const Receivers& receivers, const ReceiverBlocks& blocks, double datumM);
};

/// The overhangs and the tile for one azimuth.
struct OverhangView {
    std::span<const OverhangShapes* const> shapes;
    const OverhangTile& tile;
    glm::dvec2 away;
    HorizonCode lowest;  ///< code of the lowest sun; intervals that end below it hide none
    double cellM;
    ShadowExtent within = everywhere;  ///< extent of the relevant cells

    static constexpr ShadowExtent everywhere{-1e300, 1e300, -1e300, 1e300};
};

/// Finds the intervals that overhangs hide at one azimuth. Reuses its memory; one per thread.
class OverhangSweep {
public:
    static constexpr HorizonCode blind = ViewingBlock::blind;

    /// Selects the view, whose tile and shapes must outlive the calls that follow. Determines the blocks that
    /// can see an overhang at all, whatever their horizons; some 50 ns per layer (OverhangLayers).
    void begin(const OverhangView& view, const std::stop_token& stop);

    /// Whether an overhang may be seen from a block of the tile (index in OverhangTile::blockNumbers) whose
    /// lowest relevant horizon is `lowest`.
    [[nodiscard]] bool maySee(std::size_t block, HorizonCode lowest) const;
    /// Finds the block's intervals and calls visit as OverhangIntervals::finish() does. Some 0.1 us per layer
    /// that may be seen.
    template <class Visit>
    void look(std::size_t block, const ViewingBlock& from, HorizonCode lowest, const Visit& visit);

    /// `horizons`: of obstacles on the ground, one per number; `blind` for irrelevant ones. Returns the
    /// intervals that reach above them: receivers ascend, the intervals of a receiver ascend, are disjoint
    /// and do not touch; none if stopped. Valid until the next call. Costs as much as begin() plus look() for
    /// all blockNumbers.
    std::span<const Gap> intervals(const OverhangView& view, std::span<const HorizonCode> horizons,
                                   const std::stop_token& stop);

private:
    /// A layer that may be seen from a block, and the highest code that it reaches there.
    struct Entry {
        std::uint32_t layer;
        std::int32_t next;  // next entry of the same block
        HorizonCode maximum;
    };
    struct Range {
        double low, high;
    };
    void findInReach(double lowestTan);
    void findBlocks(std::uint32_t layer, const OverhangLayer& of, double lowestTan);
    void addBlocks(std::uint32_t layer, int row, const Range& across, HorizonCode maximum);
    [[nodiscard]] HorizonCode lowestIn(std::size_t block, std::span<const HorizonCode> horizons) const;
    [[nodiscard]] ViewingBlock blockAt(std::size_t block, std::span<const HorizonCode> horizons);
    [[nodiscard]] std::size_t columns() const;
    [[nodiscard]] glm::ivec2 firstOf(std::size_t block) const;
    [[nodiscard]] BlockAxes axesOf(std::size_t block) const;

    std::optional<OverhangView> view_;
    ShadowAxes axes_{{0, 1}};
    double alongPerMetre_ = 0;
    OverhangList inReach_;  // those of the view that may hide a sun from the tile
    OverhangLayers layers_;
    std::vector<Entry> entries_;
    std::vector<std::int32_t> firsts_;  // first entry of each block; -1: none
    OverhangIntervals look_;
    std::array<std::int32_t, ReceiverBlocks::cells> numbers_{};  // of the current block; -1: none
    std::array<float, ReceiverBlocks::cells> groundsM_{};
    std::vector<Gap> gaps_;
};

template <class Visit>
void OverhangSweep::look(std::size_t block, const ViewingBlock& from, HorizonCode lowest,
                         const Visit& visit) {
    look_.begin(from, axesOf(block), view_->lowest);
    for (std::int32_t i = firsts_[block]; i >= 0; i = entries_[std::size_t(i)].next) {
        const Entry& entry = entries_[std::size_t(i)];
        if (entry.maximum < lowest) continue;
        const OverhangLayer& layer = layers_.all()[entry.layer];
        look_.look(layer, layers_.of(layer), entry.maximum);
    }
    look_.finish(visit);
}

/// The horizons of one block as computed by a sweep.
struct SweptBlock {
    std::size_t block;         ///< index
    const HorizonCode* codes;  ///< 16 per row; null: all are noHorizon
    bool swapped;              ///< rows are columns
};

/// Adds overhangs, at the azimuths of a batch, to blocks whose horizons have just been computed. Reuses its
/// memory; one per thread.
class BatchOverhangs {
public:
    /// Selects the bins, which must form one batch, and the tile. All arguments must outlive the calls that
    /// follow.
    void begin(std::span<const OverhangShapes* const> shapes, const OverhangTile& tile,
               std::span<const SweptBin> bins, double cellM, const std::stop_token& stop);

    /// Returns a block's codes, raised where an overhang hides all suns from the horizon up to its top; valid
    /// until the next call. Calls visit(cell, low, high) for the intervals that overhangs hide separately
    /// from the horizon: of cell 16 x row + column; the intervals of a cell ascend and are disjoint.
    template <class Visit>
    const HorizonCode* raise(std::size_t bin, const SweptBlock& swept, const ReceiverBlocks& blocks,
                             const BlockGrounds& grounds, const Visit& visit);

private:
    [[nodiscard]] static std::size_t placeOf(const ReceiverBlocks& blocks, std::size_t block);
    void setBlock(const SweptBlock& swept, const ReceiverBlocks& blocks, const BlockGrounds& grounds);

    std::array<OverhangSweep, BatchLanes::maximum> sweeps_;  // one per bin
    std::array<HorizonCode, BatchLanes::maximum> lowest_{};
    ViewingBlock from_;
    BlockCodes codes_;
};

template <class Visit>
const HorizonCode* BatchOverhangs::raise(std::size_t bin, const SweptBlock& swept,
                                         const ReceiverBlocks& blocks, const BlockGrounds& grounds,
                                         const Visit& visit) {
    const std::size_t place = placeOf(blocks, swept.block);
    const HorizonCode lowest = swept.codes == nullptr
                                   ? noHorizon
                                   : findLowest(swept.codes, blocks.masks(swept.block, swept.swapped));
    if (!sweeps_[bin].maySee(place, lowest)) return swept.codes;
    setBlock(swept, blocks, grounds);
    bool raised = false;
    sweeps_[bin].look(place, from_, lowest, [&](int cell, HorizonCode low, HorizonCode high) {
        constexpr int side = ReceiverBlocks::side;
        HorizonCode& horizon = codes_.values[cell];
        // No suns are lower than the lowest sun, so the space below it does not separate an interval from the
        // horizon.
        if (int(low) > std::max(int(horizon) + 1, int(lowest_[bin])))
            return visit(swept.swapped ? cell % side * side + cell / side : cell, low, high);
        horizon = std::max(horizon, high);
        raised = true;
    });
    return raised ? codes_.values : swept.codes;
}

}  // namespace noonmark
