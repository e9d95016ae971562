#pragma once

#include <tbb/combinable.h>
#include <tbb/enumerable_thread_specific.h>

#include <atomic>
#include <cstdint>
#include <span>
#include <stop_token>
#include <vector>

#include "core/accumulate/horizon/fan_open.h"
#include "core/accumulate/horizon/period_count.h"
#include "core/accumulate/horizon/run_rays.h"
#include "core/accumulate/horizon/square_sums.h"
#include "core/accumulate/horizon/tile_horizons.h"
#include "core/accumulate/horizon/tile_sweep.h"
#include "core/accumulate/partial_field.h"
#include "core/accumulate/shadow_counts.h"
#include "core/progress.h"

namespace noonmark {

/// Sweeps the horizons of a period and counts what they hide, tile after tile. They are kept, one tile's at a
/// time, where the longest runs are wanted; else each is counted as soon as it is there.
class PeriodSweep {
public:
    /// All must outlive it. `rays` decide the longest runs in doubt; null: nobody does.
    PeriodSweep(const WallList& walls, std::span<const OpenShapes> open, const Receivers& receivers,
                const SunSteps& sun, const BinnedSun& binned, ShadowCounts counts, RunRays* rays,
                Progress& progress, std::stop_token stop);

    Result<void> run(ShadowField& field);

    /// Prisms and solids x bins x tiles.
    std::uint64_t outOfReach();

private:
    using Sums = std::vector<std::uint32_t>;
    struct Tile;
    /// The first fan of every `all`, up to `turn`; all fans, where there is one turn.
    struct Turns {
        std::size_t turn = 0, all = 1;
        [[nodiscard]] bool have(std::size_t fan) const { return fan % all <= turn; }
    };

    [[nodiscard]] std::vector<TileBox> tiles() const;
    template <class Work>
    void timed(ShadowField& field, const char* stage, Work&& work);
    void sweep(Tile& tile, const ShadowField& field);
    void sweep(const FanRange& fan, Tile& tile);
    /// What a thread works with.
    struct Desk {
        TileSweep sweep;
        SquareSums sums;
        FanOpen open;
    };
    const HorizonCode* withOpen(const FanRange& fan, std::size_t i, const SweptSquare& square, Tile& tile,
                                Desk& desk);
    Sums hidden(Tile& tile, const Turns& turns);
    [[nodiscard]] Sums hiddenByKept(Tile& tile, const Turns& turns) const;
    PartialField partialOf(Tile& tile, const Turns& turns, const ShadowField& blank);
    void count(Tile& tile, ShadowField& field);
    void countRuns(const Tile& tile, ShadowField& field);
    void report(const ReceiverBlocks& blocks, double fraction);

    const WallList& walls_;
    OpenList open_;
    const Receivers& receivers_;
    const BinnedSun& binned_;
    std::vector<SweptBin> bins_;
    std::vector<FanRange> fans_;
    PeriodCount count_;
    RunDoubts doubts_;
    RunRays* rays_;
    bool keeps_;  // horizons
    Progress& progress_;
    std::stop_token stop_;
    std::size_t receiversDone_ = 0;
    bool oneTile_ = true;
    tbb::enumerable_thread_specific<Desk> desks_;
    tbb::enumerable_thread_specific<RunMemory> runMemory_;
    tbb::combinable<std::uint64_t> outOfReach_{[] { return std::uint64_t{0}; }};
};

}  // namespace noonmark
