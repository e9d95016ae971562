#include "core/engines/horizon/cache/tile_edit.h"

#include <cmath>
#include <cstring>

namespace noonmark {

namespace {}

void BlockMarks::begin(std::size_t blocks) {
    if (marks_.size() != blocks || ++turn_ == 0) {
        marks_.assign(blocks, 0);
        turn_ = 1;
    }
}

void ShadedBlocks::begin(const WallSet& set, const ShadowAxes& axes, double lowestTan, double cellM) {
    shadows_.clear();
    const auto add = [&](const auto& obstacle) {
        Shadow shadow;
        shadow.extent.addBox(axes, obstacle.low, obstacle.high);
        shadow.foot = shadow.extent.highAlong;
        shadow.rise = double(obstacle.topM) * axes.alongPerDistance / cellM;
        shadow.extent.highAlong += shadow.rise / lowestTan + 2;
        shadow.extent.lowAlong -= 1;
        shadows_.push_back(shadow);
    };
    std::ranges::for_each(set.prisms, add);
    std::ranges::for_each(set.solids, add);
}

void ShadedBlocks::find(const ReceiverBlocks& blocks, const ShadowAxes& axes, BlockMarks& marks,
                        std::vector<std::size_t>& found) const {
    for (const Shadow& shadow : shadows_) find(shadow, blocks, axes, marks, found);
}

// Finds, row by row of blocks, those that overlap the shadow's range of q.
void ShadedBlocks::find(const Shadow& shadow, const ReceiverBlocks& blocks, const ShadowAxes& axes,
                        BlockMarks& marks, std::vector<std::size_t>& found) const {
    const TileBox& box = blocks.box();
    const ShadowExtent& extent = shadow.extent;
    const int from = axes.swapped ? box.firstColumn : box.firstRow,
              other = axes.swapped ? box.firstRow : box.firstColumn;
    const int alongs = axes.swapped ? blocks.blockCounts().x : blocks.blockCounts().y,
              acrosses = axes.swapped ? blocks.blockCounts().y : blocks.blockCounts().x;
    for (int row = 0; row < alongs; ++row) {
        const double one = axes.sign * (from + row * ReceiverBlocks::side),
                     last = one + axes.sign * (ReceiverBlocks::side - 1);
        if (std::max(one, last) < extent.lowAlong || std::min(one, last) > extent.highAlong) continue;
        const double a = axes.k * axes.sign * (from + row * ReceiverBlocks::side),
                     b = a + axes.k * axes.sign * ReceiverBlocks::side;
        const double low = extent.lowQ + std::min(a, b) - other - 1,
                     high = extent.highQ + std::max(a, b) - other + 1;
        const int first = int(std::clamp(std::floor(low / ReceiverBlocks::side), 0.0, double(acrosses))),
                  end = int(std::clamp(std::floor(high / ReceiverBlocks::side) + 1, 0.0, double(acrosses)));
        for (int i = first; i < end; ++i) {
            const int block = axes.swapped ? blocks.blockAt(row, i) : blocks.blockAt(i, row);
            if (block >= 0 && marks.mark(std::size_t(block))) found.push_back(std::size_t(block));
        }
    }
}

bool ShadedBlocks::mayRaise(const ReceiverBlocks::Block& block, const ShadowAxes& axes,
                            HorizonCode code) const {
    const double steepness = double(toSteepness(code)) * (1 - 1e-5);
    const double one = axes.from({block.column, block.row}).along,
                 other = axes.from({block.column + ReceiverBlocks::side - 1,
                                    block.row + ReceiverBlocks::side - 1})
                             .along;
    return std::ranges::any_of(shadows_, [&](const Shadow& shadow) {
        const double distance = std::min(one, other) - shadow.foot;
        return shadow.rise * (1 - steepness) > steepness * (distance - 0.1);
    });
}

ShadowExtent ShadedBlocks::extentIn(const ShadowExtent& tile) const {
    ShadowExtent extent = tile;
    extent.lowQ = tile.highQ, extent.highQ = tile.lowQ;
    for (const Shadow& shadow : shadows_) {
        extent.lowQ = std::min(extent.lowQ, shadow.extent.lowQ - 1);
        extent.highQ = std::max(extent.highQ, shadow.extent.highQ + 1);
    }
    extent.lowQ = std::max(extent.lowQ, tile.lowQ);
    extent.highQ = std::max(extent.lowQ, std::min(extent.highQ, tile.highQ));
    return extent;
}

namespace {

/// Two states of the same cells.
struct Comparison {
    const Receivers &before, &now;
    bool heights = !before.flat() && !now.flat();

    [[nodiscard]] bool differs(std::size_t cell) const {
        const bool is = isReceiver(now.kind[cell]);
        if (is != isReceiver(before.kind[cell])) return true;
        return is && heights && now.groundM[cell] != before.groundM[cell];
    }

    // Whether a range of cells is identical bit for bit.
    [[nodiscard]] bool same(std::size_t first, std::size_t count) const {
        const auto equal = [&](const auto& a, const auto& b) {
            return std::memcmp(&a[first], &b[first], count * sizeof(a[first])) == 0;
        };
        return equal(before.kind, now.kind) && (!heights || equal(before.groundM, now.groundM));
    }
};

void add(ReceiverBlocks::Masks& masks, int row, int place) {
    masks[std::size_t(row)] |= std::uint16_t(1U << unsigned(place));
}

/// Applies the change of one cell at a time.
struct CellChange {
    ReceiverBlocks& blocks;
    CachedCells& known;
    ChangedReceivers& cells;

    void update(const ReceiverBlocks::CellSlot& slot, std::uint32_t cell, bool receiver, bool heightStays) {
        const bool was = blocks.cell(slot.number) != ReceiverBlocks::padding;
        blocks.update(slot, cell, receiver);
        if (!receiver) {
            if (was) cells.formerNumbers.push_back(slot.number);
            return;
        }
        cells.newNumbers.push_back(slot.number);
        cells.newBlocks.push_back(slot.block);
        add(cells.newRows[slot.block], slot.y, slot.x);
        if (heightStays && known.has(slot)) return;
        known.add(slot);
        add(cells.unknownRows[slot.block], slot.y, slot.x);
        add(cells.unknownColumns[slot.block], slot.x, slot.y);
    }
};

}  // namespace

std::vector<std::uint32_t> findChangedReceivers(const Receivers& before, const Receivers& now) {
    std::vector<std::uint32_t> cells;
    const Comparison comparison{before, now};
    const auto columns = std::size_t(now.grid.columns);
    for (std::size_t first = 0; first < now.kind.size(); first += columns) {
        if (comparison.same(first, columns)) continue;
        for (std::size_t cell = first; cell < first + columns; ++cell)
            if (comparison.differs(cell)) cells.push_back(std::uint32_t(cell));
    }
    return cells;
}

ChangedReceivers update(ReceiverBlocks& blocks, CachedCells& known, const Receivers& now,
                        std::span<const std::uint32_t> cells) {
    ChangedReceivers changed;
    for (auto* masks : {&changed.newRows, &changed.unknownRows, &changed.unknownColumns})
        masks->resize(blocks.blocks().size());
    CellChange change{blocks, known, changed};
    const TileBox& box = blocks.box();
    for (const std::uint32_t cell : cells) {
        const int column = int(cell % std::uint32_t(now.grid.columns)),
                  row = int(cell / std::uint32_t(now.grid.columns));
        if (column < box.firstColumn || column >= box.firstColumn + box.columns || row < box.firstRow ||
            row >= box.firstRow + box.rows)
            continue;
        change.update(blocks.findSlot(column, row), cell, isReceiver(now.kind[cell]), now.flat());
    }
    std::ranges::sort(changed.newBlocks);
    changed.newBlocks.erase(std::unique(changed.newBlocks.begin(), changed.newBlocks.end()),
                            changed.newBlocks.end());
    return changed;
}

}  // namespace noonmark
