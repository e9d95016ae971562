#include "core/engines/horizon/overhangs/overhang_tile.h"

#include "core/engines/ray/ray_reference.h"

namespace noonmark {

namespace {
constexpr int side = ReceiverBlocks::side;
}  // namespace

OverhangTile::OverhangTile(const Receivers& receivers, const ReceiverBlocks& blocks, double datumM)
    : box(blocks.box()), numbers(std::size_t(box.columns) * std::size_t(box.rows), -1) {
    if (!receivers.flat()) groundsM.resize(blocks.numbers());
    const glm::ivec2 all = blocks.blockCounts();
    blockNumbers.assign(std::size_t(all.x) * std::size_t(all.y), {0, 0});
    for (const ReceiverBlocks::Block& block : blocks.blocks()) {
        blockNumbers[std::size_t((block.row - box.firstRow) / side) * std::size_t(all.x) +
                     std::size_t((block.column - box.firstColumn) / side)] = {block.first,
                                                                              block.first + block.count};
        const std::uint8_t* places = blocks.places(block, false);
        for (std::uint32_t n = 0; n < block.count; ++n) {
            const int column = block.column - box.firstColumn + places[n] % ReceiverBlocks::side,
                      row = block.row - box.firstRow + places[n] / ReceiverBlocks::side;
            if (column >= box.columns || row >= box.rows) continue;
            const std::uint32_t number = block.first + n, cell = blocks.cell(number);
            numbers[std::size_t(row) * std::size_t(box.columns) + std::size_t(column)] = std::int32_t(number);
            if (!receivers.flat() && cell != ReceiverBlocks::padding)
                groundsM[number] = float(double(placeRayOrigin(receivers.position(cell)).z) - datumM);
        }
    }
}

}  // namespace noonmark
