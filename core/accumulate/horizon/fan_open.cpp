#include "core/accumulate/horizon/fan_open.h"

#include <algorithm>

namespace noonmark {

void FanOpen::begin(std::span<const OpenShapes* const> shapes, const OpenTile& tile,
                    std::span<const SweptBin> bins, double cellM, const std::stop_token& stop) {
    for (std::size_t bin = 0; bin < bins.size(); ++bin) {
        const auto [away, lowest] = bins[bin];
        lowest_[bin] = lowest;
        sweeps_[bin].begin({.shapes = shapes, .tile = tile, .away = away, .lowest = lowest, .cellM = cellM},
                           stop);
    }
}

std::size_t FanOpen::placeOf(const ReceiverBlocks& blocks, std::size_t block) {
    const ReceiverBlocks::Block& of = blocks.blocks()[block];
    const TileBox& box = blocks.box();
    return std::size_t((of.row - box.firstRow) / ReceiverBlocks::side) * std::size_t(blocks.squares().x) +
           std::size_t((of.column - box.firstColumn) / ReceiverBlocks::side);
}

void FanOpen::setSquare(const SweptSquare& square, const ReceiverBlocks& blocks,
                        const BlockGrounds& grounds) {
    if (square.codes == nullptr)
        std::ranges::fill(codes_.values, noHorizon);
    else
        std::copy_n(square.codes, ReceiverBlocks::cells, codes_.values);
    from_.horizons = codes_;
    setOthers(blocks.masks(square.block, square.swapped), OpenSquare::blind, from_.horizons);
    const Line<float>* groundsM = grounds.of(square.block, square.swapped).linesM;
    from_.groundsM = groundsM == nullptr ? nullptr : groundsM->values;
}

}  // namespace noonmark
