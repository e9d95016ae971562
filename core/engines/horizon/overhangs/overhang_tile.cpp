#include "core/engines/horizon/overhangs/overhang_tile.h"

#include "core/engines/ray/ray_reference.h"

namespace noonmark {

OverhangTile::OverhangTile(const Receivers& receivers, const ReceiverBlocks& blocks, double datumM)
    : box(blocks.box()) {
    constexpr int side = ReceiverBlocks::side;
    if (!receivers.flat()) groundsM.resize(blocks.numbers());
    const glm::ivec2 all = blocks.blockCounts();
    blockNumbers.assign(std::size_t(all.x) * std::size_t(all.y), {0, 0});
    firstOfBlock.assign(blockNumbers.size(), -1);
    for (const ReceiverBlocks::Block& block : blocks.blocks()) {
        const std::size_t index = indexOf(block), first = numbers.size();
        blockNumbers[index] = {block.first, block.first + block.count};
        firstOfBlock[index] = std::int32_t(first);
        numbers.resize(first + ReceiverBlocks::cells, -1);
        const std::uint8_t* places = blocks.places(block, false);
        for (std::uint32_t n = 0; n < block.count; ++n) {
            const int column = block.column - box.firstColumn + places[n] % side,
                      row = block.row - box.firstRow + places[n] / side;
            if (column >= box.columns || row >= box.rows) continue;
            const std::uint32_t number = block.first + n, cell = blocks.cell(number);
            numbers[first + places[n]] = std::int32_t(number);
            if (!receivers.flat() && cell != ReceiverBlocks::padding)
                groundsM[number] = float(double(placeRayOrigin(receivers.position(cell)).z) - datumM);
        }
    }
}

}  // namespace noonmark
