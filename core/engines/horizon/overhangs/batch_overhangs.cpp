#include "core/engines/horizon/overhangs/batch_overhangs.h"

#include <algorithm>

namespace noonmark {

void BatchOverhangs::begin(std::span<const OverhangShapes* const> shapes, const OverhangTile& tile,
                           std::span<const SweptBin> bins, double cellM, const std::stop_token& stop) {
    for (std::size_t bin = 0; bin < bins.size(); ++bin) {
        const auto [away, lowest] = bins[bin];
        lowest_[bin] = lowest;
        sweeps_[bin].begin({.shapes = shapes, .tile = tile, .away = away, .lowest = lowest, .cellM = cellM},
                           stop);
    }
}

std::size_t BatchOverhangs::placeOf(const ReceiverBlocks& blocks, std::size_t block) {
    const ReceiverBlocks::Block& of = blocks.blocks()[block];
    const TileBox& box = blocks.box();
    return std::size_t((of.row - box.firstRow) / ReceiverBlocks::side) * std::size_t(blocks.blockCounts().x) +
           std::size_t((of.column - box.firstColumn) / ReceiverBlocks::side);
}

void BatchOverhangs::setBlock(const SweptBlock& swept, const ReceiverBlocks& blocks,
                              const BlockGrounds& grounds) {
    if (swept.codes == nullptr)
        std::ranges::fill(codes_.values, noHorizon);
    else
        std::copy_n(swept.codes, ReceiverBlocks::cells, codes_.values);
    from_.horizons = codes_;
    setOthers(blocks.masks(swept.block, swept.swapped), ViewingBlock::blind, from_.horizons);
    const CacheLine<float>* groundsM = grounds.of(swept.block, swept.swapped).rowsM;
    from_.groundsM = groundsM == nullptr ? nullptr : groundsM->values;
}

}  // namespace noonmark
