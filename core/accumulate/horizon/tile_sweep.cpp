#include "core/accumulate/horizon/tile_sweep.h"

#include <algorithm>

namespace noonmark {

void TileSweep::begin(const TileScene& scene, std::span<const SweptBin> bins) {
    horizons_.begin(bins, scene.cellM);
    const AzimuthFan& fan = horizons_.fan();
    walls_.find(scene.walls, scene.walls.prisms, fan, extentOf(scene.blocks.box(), fan.axes), scene.cellM,
                horizons_.lowestTan());
}

void TileSweep::begin(const TileScene& scene, const SweptBin& bin, const std::stop_token& stop) {
    const ShadowExtent extent = extentOf(scene.blocks.box(), ShadowAxes(bin.away));
    squares_.begin(scene.walls, allOf(scene.walls), bin.away, extent, bin.lowest, scene.cellM, stop);
}

void writeSquare(const HorizonCode* square, const ReceiverBlocks& blocks, const ReceiverBlocks::Block& block,
                 bool swapped, HorizonCode* codes) {
    HorizonCode* to = codes + block.first;
    const std::uint32_t padded = (block.count + 31) / 32 * 32;
    const std::uint8_t* places = blocks.places(block, swapped);
    const std::uint32_t written = square == nullptr ? 0 : block.count;
    for (std::uint32_t i = 0; i < written; ++i) to[i] = square[places[i]];
    std::fill(to + written, to + padded, noHorizon);
}

}  // namespace noonmark
