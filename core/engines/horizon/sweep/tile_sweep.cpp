#include "core/engines/horizon/sweep/tile_sweep.h"

#include <algorithm>

namespace noonmark {

// The codes take hundreds of megabytes; they are written once, bin by bin, and read across bins. With huge
// pages, reading across bins moves only a page or two from one bin to the next.
TileHorizons::TileHorizons(std::size_t bins, std::size_t numbers)
    : numbers_(numbers),
      codes_(static_cast<HorizonCode*>(allocateHugePages(bins * numbers * sizeof(HorizonCode)))) {}

void TileSweep::begin(const TileScene& scene, std::span<const SweptBin> bins) {
    horizons_.begin(bins, scene.cellM);
    const AzimuthBatch& batch = horizons_.batch();
    walls_.find(scene.walls, scene.walls.prisms, batch, extentOf(scene.blocks.box(), batch.axes), scene.cellM,
                horizons_.lowestTan());
}

void TileSweep::begin(const TileScene& scene, const SweptBin& bin, const std::stop_token& stop) {
    const ShadowExtent extent = extentOf(scene.blocks.box(), ShadowAxes(bin.away));
    blockSweep_.begin(scene.walls, listAllObstacles(scene.walls), bin.away, extent, bin.lowest, scene.cellM,
                      stop);
}

void writeBlock(const HorizonCode* swept, const ReceiverBlocks& blocks, const ReceiverBlocks::Block& block,
                bool swapped, HorizonCode* codes) {
    HorizonCode* to = codes + block.first;
    const std::uint32_t padded = (block.count + 31) / 32 * 32;
    const std::uint8_t* places = blocks.places(block, swapped);
    const std::uint32_t written = swept == nullptr ? 0 : block.count;
    for (std::uint32_t i = 0; i < written; ++i) to[i] = swept[places[i]];
    std::fill(to + written, to + padded, noHorizon);
}

}  // namespace noonmark
