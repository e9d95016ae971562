#include "core/engines/horizon/cache/changed_receivers.h"

#include <algorithm>
#include <cstring>

namespace noonmark {

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
            if (was) cells.goneNumbers.push_back(slot.number);
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
