#pragma once

#include <tbb/combinable.h>
#include <tbb/enumerable_thread_specific.h>

#include <cstdint>
#include <span>
#include <stop_token>
#include <vector>

#include "core/accumulate/horizon/bin_sweep.h"
#include "core/accumulate/horizon/open_parts.h"
#include "core/accumulate/horizon/period_count.h"
#include "core/accumulate/horizon/tile_horizons.h"
#include "core/accumulate/partial_field.h"
#include "core/progress.h"

namespace noonmark {

/// Sweeps the horizons of a period and counts what they hide, tile after tile.
class PeriodSweep {
public:
    /// All must outlive it.
    PeriodSweep(const WallList& walls, std::span<const OpenTriangle> open, const Receivers& receivers,
                const SunSteps& sun, const BinnedSun& binned, Progress& progress, std::stop_token stop);

    Result<void> run(ShadowField& field);

    /// Prisms and solids x bins x tiles.
    std::uint64_t outOfReach();

private:
    using Sums = std::vector<std::uint32_t>;
    struct TileWork;
    /// The first bin of every `all`, up to `turn`; all bins, where there is one turn.
    struct Turns {
        std::size_t turn = 0, all = 1;
        [[nodiscard]] bool have(std::size_t bin) const { return bin % all <= turn; }
    };

    template <class Work>
    void timed(ShadowField& field, const char* stage, Work&& work);
    void sweep(const ReceiverBlocks& blocks, TileHorizons& horizons, const ShadowField& field);
    void sweep(std::size_t bin, TileWork& work);
    [[nodiscard]] Sums hidden(const ReceiverBlocks& blocks, const TileHorizons& horizons,
                              const Turns& turns) const;
    [[nodiscard]] PartialField partialOf(const ReceiverBlocks& blocks, const TileHorizons& horizons,
                                         const Turns& turns, const ShadowField& blank) const;
    void count(const ReceiverBlocks& blocks, const TileHorizons& horizons, ShadowField& field);
    void report(const ReceiverBlocks& blocks, double fraction);

    const WallList& walls_;
    std::span<const OpenTriangle> open_;
    std::vector<std::vector<Gap>> gaps_;  // of each bin of the tile at hand
    const Receivers& receivers_;
    const BinnedSun& binned_;
    PeriodCount count_;
    Progress& progress_;
    std::stop_token stop_;
    std::size_t receiversDone_ = 0;
    bool oneTile_ = true;
    tbb::enumerable_thread_specific<SquareSweep> sweeps_;
    tbb::enumerable_thread_specific<OpenSweep> openSweeps_;
    tbb::enumerable_thread_specific<RunMemory> runMemory_;
    tbb::combinable<std::uint64_t> outOfReach_{[] { return std::uint64_t{0}; }};
};

}  // namespace noonmark
