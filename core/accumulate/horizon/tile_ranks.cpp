#include "core/accumulate/horizon/tile_ranks.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/accumulate/horizon/raise_line.h"

namespace noonmark {

namespace {
// Lines that are swept before their cells are looked up: neighbours across lie on the same cache lines.
constexpr int linesABlock = 16;
// Walls that are raised before the lowest horizon of a line is looked for again.
constexpr int wallsALook = 8;

Line<float> lineOf(float value) {
    Line<float> line;
    std::ranges::fill(line.values, value);
    return line;
}

WallOnLine onLine(const LineWall& wall, int line, int first, int end) {
    const double low = wall.lowQ - line, high = wall.highQ - line;
    const double along = wall.along0 - wall.slope * low;
    const double atLow = along + wall.slope * std::max(low, 0.0),
                 atHigh = along + wall.slope * std::min(high, 1.0);
    // A cell too many at either end does no harm: raiseLine() looks at each.
    const double from = std::min(atLow, atHigh) - 1, to = std::max(atLow, atHigh) + double(wall.reach) + 2;
    return {.along = float(along),
            .slope = float(wall.slope),
            .lowQ = float(low),
            .highQ = float(high),
            .farthest = float(std::max(atLow, atHigh)),
            .rise = wall.rise,
            .nearest = wall.nearest,
            .first = int(std::clamp(from, double(first), double(end))),
            .end = int(std::clamp(to, double(first), double(end)))};
}

}  // namespace

TileReceivers::TileReceivers(const Receivers& receivers, const TileBox& box)
    : box_(box), byRow_(std::size_t(box.columns) * std::size_t(box.rows), -1), byColumn_(byRow_) {
    for (int row = 0; row < box.rows; ++row)
        for (int column = 0; column < box.columns; ++column) {
            const std::size_t cell = receivers.grid.index(box.firstColumn + column, box.firstRow + row);
            if (receivers.kind[cell] != CellKind::ground) continue;
            const auto number = std::int32_t(cells_.size());
            byRow_[std::size_t(row) * std::size_t(box.columns) + std::size_t(column)] = number;
            byColumn_[std::size_t(column) * std::size_t(box.rows) + std::size_t(row)] = number;
            cells_.push_back(std::uint32_t(cell));
        }
}

TileRanks::TileRanks(std::size_t bins, std::size_t receivers)
    : bins_(bins),
      receivers_(receivers),
      stride_(receivers),
      ranks_(std::make_unique_for_overwrite<std::int16_t[]>(bins * receivers)) {}

void TileRanks::copyBlock(std::size_t block, std::vector<BlockRanks>& ranks) const {
    const std::size_t first = block * receiversABlock, count = std::min(receiversABlock, receivers_ - first);
    ranks.resize(bins_);
    for (std::size_t bin = 0; bin < bins_; ++bin) {
        const std::int16_t* from = ranks_.get() + bin * stride_ + first;
        std::copy(from, from + count, ranks[bin].values);
        std::fill(ranks[bin].values + count, ranks[bin].values + receiversABlock, std::int16_t{0});
    }
}

std::uint64_t BinSweep::sweep(const WallList& walls, const TileReceivers& receivers, const AzimuthBin& bin,
                              double cellM, std::int16_t* ranks, const std::stop_token& stop) {
    const ShearedTile tile(receivers.box(), bin.away());
    walls_.find(walls, tile, cellM, bin.lowestTan());
    stride_ = (std::size_t(tile.length()) + 15) / 16;
    horizons_.resize(stride_ * linesABlock);
    for (int first = 0; first < tile.lines() && !stop.stop_requested(); first += linesABlock) {
        clearLines(tile, receivers, first);
        for (int line = first; line < std::min(first + linesABlock, tile.lines()); ++line)
            raise(tile, line, horizons_[std::size_t(line - first) * stride_].values);
        writeLines(tile, receivers, bin, first, ranks);
    }
    return walls_.prismsOutOfReach();
}

// Cells that are no receivers get a horizon that no wall beats.
void BinSweep::clearLines(const ShearedTile& tile, const TileReceivers& receivers, int firstLine) {
    constexpr float none = std::numeric_limits<float>::infinity();
    std::ranges::fill(horizons_, lineOf(none));
    float* horizons = horizons_.front().values;
    for (int along = 0; along < tile.length(); ++along) {
        const int across = tile.across(firstLine, along);
        const int from = std::max(0, -across), to = std::min(linesABlock, tile.width() - across);
        const std::int32_t* numbers = receivers.numbers(tile.rowAt(along), tile.swapped());
        for (int line = from; line < to; ++line)
            horizons[std::size_t(line) * stride_ * 16 + std::size_t(along)] =
                numbers[across + line] < 0 ? none : 0;
    }
}

void BinSweep::raise(const ShearedTile& tile, int line, float* horizons) {
    const int first = tile.first(line), end = tile.end(line);
    lowest_.resize(stride_);
    lowestOfSixteens(horizons, lowest_);
    float low = std::ranges::min(lowest_);                      // horizon of the line, or less
    if (low == std::numeric_limits<float>::infinity()) return;  // no receivers
    int sinceLow = 0;
    for (const std::uint32_t index : walls_.at(line)) {
        const LineWall& wall = walls_.wall(index);
        if (wall.highAlong < first && wall.rise <= low * (float(first) - float(wall.highAlong))) continue;
        const WallOnLine here = onLine(wall, line, first, end);
        if (here.first >= here.end) continue;
        raiseLine(here, tile.fractions(), horizons, lowest_.data());
        if (++sinceLow % wallsALook == 0) low = std::ranges::min(lowest_);
    }
}

void BinSweep::writeLines(const ShearedTile& tile, const TileReceivers& receivers, const AzimuthBin& bin,
                          int firstLine, std::int16_t* ranks) const {
    const float* horizons = horizons_.front().values;
    for (int along = 0; along < tile.length(); ++along) {
        const int across = tile.across(firstLine, along);
        const int from = std::max(0, -across), to = std::min(linesABlock, tile.width() - across);
        const std::int32_t* numbers = receivers.numbers(tile.rowAt(along), tile.swapped());
        for (int line = from; line < to; ++line) {
            const std::int32_t number = numbers[across + line];
            if (number >= 0)
                ranks[number] = bin.hidden(horizons[std::size_t(line) * stride_ * 16 + std::size_t(along)]);
        }
    }
}

}  // namespace noonmark
