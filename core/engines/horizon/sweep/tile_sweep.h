#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <stop_token>
#include <vector>

#include "core/base/process.h"
#include "core/engines/horizon/geometry/horizon_code.h"
#include "core/engines/horizon/geometry/shadow_axes.h"
#include "core/engines/horizon/sweep/block_sweep.h"

namespace noonmark {

/// The horizon code for each bin and number of a tile: 2 bytes each, not initialised.
class TileHorizons {
public:
    TileHorizons(std::size_t bins, std::size_t numbers);

    [[nodiscard]] std::size_t numbers() const { return numbers_; }
    [[nodiscard]] std::span<HorizonCode> of(std::size_t bin) {
        return {codes_.get() + bin * numbers_, numbers_};
    }
    [[nodiscard]] std::span<const HorizonCode> of(std::size_t bin) const {
        return {codes_.get() + bin * numbers_, numbers_};
    }

private:
    std::size_t numbers_;
    struct Free {
        void operator()(HorizonCode* codes) const { freeHugePages(codes); }
    };
    std::unique_ptr<HorizonCode[], Free> codes_;
};

/// The inputs for sweeping a tile.
struct TileScene {
    const WallList& walls;
    const ReceiverBlocks& blocks;
    const BlockGrounds& grounds;
    double cellM;

    /// Prisms only, on level ground.
    [[nodiscard]] bool even() const { return listAllObstacles(walls).even() && grounds.flat(); }
};

/// Sweeps a tile at the azimuths of a batch. Reuses its memory; one per thread.
class TileSweep {
public:
    /// Unless stopped, calls take(bin, block, codes, swapped) for each bin of the batch and each block: the
    /// bin's index in `bins`, the block's index, and its codes as from BlockSweep. Returns the number of
    /// prisms and solids out of reach, summed over bins.
    template <class Take>
    std::uint64_t run(const TileScene& scene, std::span<const SweptBin> bins, const Take& take,
                      const std::stop_token& stop) {
        return scene.even() ? runEven(scene, bins, take, stop) : runEach(scene, bins, take, stop);
    }

    /// The same for one bin with attribution: calls take(block, codes, swapped) with codes as from
    /// BlockSweep::attributedCodes().
    template <class Take>
    void runAttributed(const TileScene& scene, const SweptBin& bin, const Take& take,
                       const std::stop_token& stop);

private:
    void begin(const TileScene& scene, std::span<const SweptBin> bins);
    void begin(const TileScene& scene, const SweptBin& bin, const std::stop_token& stop);
    template <class Take>
    std::uint64_t runEven(const TileScene& scene, std::span<const SweptBin> bins, const Take& take,
                          const std::stop_token& stop);
    template <class Take>
    std::uint64_t runEach(const TileScene& scene, std::span<const SweptBin> bins, const Take& take,
                          const std::stop_token& stop);

    BinWalls walls_;
    BatchHorizons horizons_;
    BlockSweep blockSweep_;
};

/// Writes a block's codes to its numbers; null: noHorizon.
void writeBlock(const HorizonCode* swept, const ReceiverBlocks& blocks, const ReceiverBlocks::Block& block,
                bool swapped, HorizonCode* codes);

template <class Take>
std::uint64_t TileSweep::runEven(const TileScene& scene, std::span<const SweptBin> bins, const Take& take,
                                 const std::stop_token& stop) {
    constexpr std::size_t blocksATime = 64;
    begin(scene, bins);
    const bool swapped = horizons_.batch().axes.swapped;
    for (std::size_t i = 0; i < scene.blocks.blocks().size(); ++i) {
        if (i % blocksATime == 0 && stop.stop_requested()) break;
        horizons_.raise(walls_, scene.blocks.blocks()[i], scene.blocks.masks(i, swapped));
        for (std::size_t bin = 0; bin < bins.size(); ++bin) take(bin, i, horizons_.codes(bin), swapped);
    }
    return walls_.outOfReach() * bins.size();
}

template <class Take>
std::uint64_t TileSweep::runEach(const TileScene& scene, std::span<const SweptBin> bins, const Take& take,
                                 const std::stop_token& stop) {
    std::uint64_t outOfReach = 0;
    for (std::size_t bin = 0; bin < bins.size(); ++bin) {
        const bool swapped = ShadowAxes(bins[bin].away).swapped;
        begin(scene, bins[bin], stop);
        for (std::size_t i = 0; i < scene.blocks.blocks().size() && !stop.stop_requested(); ++i)
            take(bin, i,
                 blockSweep_.codes(scene.blocks.blocks()[i], scene.blocks.masks(i, swapped),
                                   scene.grounds.of(i, swapped)),
                 swapped);
        outOfReach += blockSweep_.outOfReach();
    }
    return outOfReach;
}

template <class Take>
void TileSweep::runAttributed(const TileScene& scene, const SweptBin& bin, const Take& take,
                              const std::stop_token& stop) {
    const bool swapped = ShadowAxes(bin.away).swapped;
    begin(scene, bin, stop);
    for (std::size_t i = 0; i < scene.blocks.blocks().size() && !stop.stop_requested(); ++i)
        take(i,
             blockSweep_.attributedCodes(scene.blocks.blocks()[i], scene.blocks.masks(i, swapped),
                                         scene.grounds.of(i, swapped)),
             swapped);
}

}  // namespace noonmark
