#pragma once

// The sweep itself, from a period down to one block. PeriodSweep (this file) handles tiles, batches and
// threads; TileSweep (tile_sweep.h) sweeps one tile at the azimuths of a batch. For prisms on level ground it
// uses BatchHorizons, which processes up to eight azimuths at once; otherwise BlockSweep, which also supports
// terrain, general meshes and receivers at their own heights (both in block_sweep.h). raise_block.h has the
// inner loops. TileHorizons (tile_sweep.h) stores the codes of a tile.

#include <tbb/combinable.h>
#include <tbb/enumerable_thread_specific.h>

#include <atomic>
#include <cstdint>
#include <optional>
#include <span>
#include <stop_token>
#include <vector>

#include "core/base/progress.h"
#include "core/engines/api/shadow_field.h"
#include "core/engines/horizon/counting/longest_runs.h"
#include "core/engines/horizon/counting/period_count.h"
#include "core/engines/horizon/counting/short_sums.h"
#include "core/engines/horizon/overhangs/overhang_sweep.h"
#include "core/engines/horizon/sweep/tile_sweep.h"
#include "core/engines/horizon/trees/crown_runs.h"
#include "core/engines/horizon/trees/crown_sweep.h"

namespace noonmark {

/// Sweeps the horizons of a period and counts the suns they hide, tile by tile. If longest runs are wanted,
/// the horizons of one tile at a time are stored; otherwise each horizon is counted as soon as it is known.
class PeriodSweep {
public:
    /// All arguments must outlive it. `rays` decides longest runs in doubt; null: they stay as they are.
    PeriodSweep(const WallList& walls, std::span<const OverhangShapes> overhangs, const Receivers& receivers,
                const SunSteps& sun, const BinnedSun& binned, ShadowCounts counts, RunRays* rays,
                Progress& progress, std::stop_token stop);

    /// Has crowns weighed along with the horizons; null: none. Both must outlive this object. `inLeaf`: one
    /// per step, as in CrownScene.
    void weigh(const CrownSweep* crowns, std::span<const std::uint8_t> inLeaf);
    /// Steps that crowns take, by set of CrownSweep and then by receiver; empty without crowns.
    struct TakenSteps {
        std::vector<std::vector<double>> evergreen, seasonal;
        /// Longest runs with crowns, in steps, by cell of the grid; empty if they are not counted.
        std::vector<std::int16_t> evergreenRuns, seasonalRuns;
    };
    [[nodiscard]] const TakenSteps& takenSteps() const { return taken_; }

    Result<void> run(ShadowField& field);

    /// Number of prisms and solids out of reach, summed over bins and tiles.
    std::uint64_t outOfReach();

private:
    using Sums = std::vector<std::uint32_t>;
    struct Tile;
    /// Batches are processed in `all` turns; batch b belongs to turn b % all. Covers the turns up to `turn`;
    /// by default, all batches.
    struct Turns {
        std::size_t turn = 0, all = 1;
        [[nodiscard]] bool have(std::size_t batch) const { return batch % all <= turn; }
    };

    [[nodiscard]] std::vector<TileBox> tiles() const;
    template <class Work>
    void timed(ShadowField& field, const char* stage, Work&& work);
    void sweep(Tile& tile, const ShadowField& field);
    void sweep(const BatchRange& batch, Tile& tile);
    /// Per-thread memory.
    struct Workspace {
        TileSweep sweep;
        BlockSums sums;
        BatchOverhangs overhangs;
        CrownBatch crowns;
        CrownSums crownSums;
    };
    const HorizonCode* withOverhangs(const BatchRange& batch, std::size_t i, const SweptBlock& swept,
                                     Tile& tile, Workspace& workspace);
    Sums hidden(Tile& tile, const Turns& turns);
    [[nodiscard]] Sums hiddenByCached(Tile& tile, const Turns& turns) const;
    PartialField partialOf(Tile& tile, const Turns& turns, const ShadowField& blank);
    void count(Tile& tile, ShadowField& field);
    void countCrowns(const Tile& tile);
    [[nodiscard]] std::vector<std::uint32_t> listReceiverNumbers(const ReceiverBlocks& blocks) const;
    void addTaken(const ReceiverBlocks& blocks, const CrownSums& sums, std::size_t set,
                  const std::vector<std::uint32_t>& receivers);
    void countRuns(const Tile& tile, ShadowField& field);
    void countCrownRuns(const Tile& tile, std::size_t part, const RunLanes& decided, const RunMemory& memory);
    void report(const ReceiverBlocks& blocks, double fraction);

    const WallList& walls_;
    OverhangList overhangs_;
    const Receivers& receivers_;
    const BinnedSun& binned_;
    std::vector<SweptBin> bins_;
    std::vector<BatchRange> batches_;
    PeriodCount count_;
    RunDoubts doubts_;
    RunRays* rays_;
    const CrownSweep* crowns_ = nullptr;
    std::optional<CrownRunCount> crownRuns_;
    TakenSteps taken_;
    bool keeps_;  // whether horizons are stored
    Progress& progress_;
    std::stop_token stop_;
    std::size_t receiversDone_ = 0;
    bool oneTile_ = true;
    tbb::enumerable_thread_specific<Workspace> workspaces_;
    tbb::enumerable_thread_specific<RunMemory> runMemory_;
    tbb::enumerable_thread_specific<CrownRunCount::Memory> crownRunMemory_;
    tbb::combinable<std::uint64_t> outOfReach_{[] { return std::uint64_t{0}; }};
};

}  // namespace noonmark
