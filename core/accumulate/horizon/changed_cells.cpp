#include "core/accumulate/horizon/changed_cells.h"

namespace noonmark {

namespace {

constexpr int side = ReceiverBlocks::side;

void addCell(ChangedCells& cells, std::size_t block, std::uint8_t place) {
    const int x = place % side, y = place / side;
    cells.newRows[block][std::size_t(y)] |= std::uint16_t(1U << unsigned(x));
    cells.newColumns[block][std::size_t(x)] |= std::uint16_t(1U << unsigned(y));
}

}  // namespace

ChangedCells changedCells(const ReceiverBlocks& now, const ReceiverBlocks& before, const Receivers& receivers,
                          std::span<const float> groundBeforeM) {
    ChangedCells cells;
    cells.newRows.resize(now.blocks().size());
    cells.newColumns.resize(now.blocks().size());
    for (std::size_t i = 0; i < now.blocks().size(); ++i) {
        const ReceiverBlocks::Block& block = now.blocks()[i];
        if (receivers.flat() && now.masks(i, false) == before.masks(i, false)) continue;
        const std::size_t known = cells.newNumbers.size();
        for (std::uint32_t number = block.first; number < block.first + block.count; ++number) {
            const std::uint32_t cell = now.cell(number), old = before.cell(number);
            const bool is = cell != ReceiverBlocks::padding, was = old != ReceiverBlocks::padding;
            if (was && !is) cells.goneNumbers.push_back(number);
            if (!is || (was && (receivers.flat() || receivers.groundM[cell] == groundBeforeM[cell])))
                continue;
            cells.newNumbers.push_back(number);
            addCell(cells, i, now.places(block, false)[number - block.first]);
        }
        if (cells.newNumbers.size() > known) cells.newBlocks.push_back(i);
    }
    return cells;
}

}  // namespace noonmark
