#pragma once

#include <cstdint>
#include <memory>
#include <stop_token>
#include <vector>

#include "core/accumulate/horizon/azimuth_bins.h"
#include "core/accumulate/horizon/line_walls.h"
#include "core/accumulate/horizon/longest_runs.h"
#include "core/accumulate/horizon/sheared_tile.h"
#include "core/receivers/receivers.h"

namespace noonmark {

/// The receivers of a tile by number, found from a cell or in order.
class TileReceivers {
public:
    TileReceivers(const Receivers& receivers, const TileBox& box);

    [[nodiscard]] const TileBox& box() const { return box_; }
    [[nodiscard]] std::size_t count() const { return cells_.size(); }
    /// Cell of the whole grid.
    [[nodiscard]] std::uint32_t cell(std::size_t number) const { return cells_[number]; }
    /// Numbers of a row's cells (`byColumn`: of a column's), -1 where there is no receiver.
    [[nodiscard]] const std::int32_t* numbers(int row, bool byColumn) const {
        return byColumn ? byColumn_.data() + std::size_t(row) * std::size_t(box_.rows)
                        : byRow_.data() + std::size_t(row) * std::size_t(box_.columns);
    }

private:
    TileBox box_;
    std::vector<std::uint32_t> cells_;
    std::vector<std::int32_t> byRow_, byColumn_;
};

/// For each bin and receiver of a tile, how many of the bin's steps its horizon hides.
class TileRanks {
public:
    /// 2 bytes for each bin and receiver.
    TileRanks(std::size_t bins, std::size_t receivers);

    [[nodiscard]] std::int16_t* of(std::size_t bin) { return ranks_.get() + bin * stride_; }
    /// Those of receivers [64 block, 64 block + 64), one a bin; beyond the last receiver 0.
    void copyBlock(std::size_t block, std::vector<BlockRanks>& ranks) const;

private:
    std::size_t bins_, receivers_, stride_;
    std::unique_ptr<std::int16_t[]> ranks_;  // each written once, so not cleared first
};

/// Sweeps one bin over one tile. Keeps its memory from one to the next; one for each thread.
class BinSweep {
public:
    /// Writes a rank for each receiver, unless stopped. Returns the number of prisms out of reach.
    std::uint64_t sweep(const WallList& walls, const TileReceivers& receivers, const AzimuthBin& bin,
                        double cellM, std::int16_t* ranks, const std::stop_token& stop);

private:
    void clearLines(const ShearedTile& tile, const TileReceivers& receivers, int firstLine);
    void raise(const ShearedTile& tile, int line, float* horizons);
    void writeLines(const ShearedTile& tile, const TileReceivers& receivers, const AzimuthBin& bin,
                    int firstLine, std::int16_t* ranks) const;

    LineWalls walls_;
    std::size_t stride_ = 0;  // cache lines of horizons_ for one line of the tile
    std::vector<Line<float>> horizons_;
    std::vector<float> lowest_;  // of every 16 cells of the line at hand
};

}  // namespace noonmark
