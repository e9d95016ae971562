#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "core/engines/horizon/counting/walk_steps.h"
#include "core/engines/horizon/geometry/receiver_blocks.h"
#include "core/engines/horizon/trees/crown_sweep.h"

namespace noonmark {

/// The altitudes at which crowns take at least TreeShade::defaultShadedFrom of the sun from the cells of a
/// tile, for longest runs: levels of a bin as bits, for each number of a block. Threads may set those of
/// different bins or blocks at the same time. Memory: up to 4 bytes for each bin and cell near trees.
class CrownMarks {
public:
    using Levels = std::uint16_t;
    /// Of the cells of a block, 16 a row.
    struct Block {
        alignas(64) Levels inLeaf[ReceiverBlocks::cells], bare[ReceiverBlocks::cells];
        bool anyInLeaf = false, anyBare = false;
    };

    void begin(std::size_t bins, const ReceiverBlocks& blocks);
    void set(std::size_t bin, std::size_t block, bool swapped, const Block& marks);

    /// Levels of the 64 numbers of a part, in leaf and bare; null halves: none.
    struct Part {
        const Levels* inLeaf[2] = {};
        const Levels* bare[2] = {};
    };
    [[nodiscard]] Part of(std::size_t bin, std::size_t part) const;

private:
    struct Entry {
        std::unique_ptr<Levels[]> inLeaf, bare;  ///< one per number of the block, padding included
    };
    [[nodiscard]] std::unique_ptr<Levels[]> copyMarks(std::size_t block, bool swapped,
                                                      const Levels* of) const;

    const ReceiverBlocks* blocks_ = nullptr;
    std::vector<Entry> entries_;              // bin by bin
    std::vector<std::uint32_t> blockOfHalf_;  // of 32 numbers
};

/// Longest runs in the shade of crowns and buildings, in steps: a step is in shade where its horizon hides it
/// or crowns take TreeShade::defaultShadedFrom of the sun at its level. Immutable.
///
/// Error: crowns are looked at in up to CrownSweep::maxLevels altitudes a bin, so that a run may begin or end
/// at the wrong step where the sun passes a crown's upper or lower edge; light between overhangs and the
/// ground counts as lit.
class CrownRunCount {
public:
    /// `steps` are those of the period, `inLeaf` one for each.
    CrownRunCount(const CrownSweep& sweep, std::span<const TimedStep> steps,
                  std::span<const std::uint8_t> inLeaf);

    /// Working memory; one per thread.
    struct Memory {
        std::vector<const std::int16_t*> inLeaf, bare;  // lanes of each bin and level
        std::vector<RunLanes> made;
    };
    struct Runs {
        RunLanes evergreen, seasonal;
    };
    /// `horizons`: those of a part, one entry per bin. `plain`: their longest runs, and `decided`: the same
    /// after rays. Where crowns make no run longer it stays that of `decided`, and none is shorter.
    [[nodiscard]] Runs of(std::span<const RunLanes> horizons, const CrownMarks& marks, std::size_t part,
                          const RunLanes& plain, const RunLanes& decided, Memory& memory) const;

private:
    bool findLanes(std::span<const RunLanes> horizons, const CrownMarks& marks, std::size_t part,
                   Memory& memory) const;

    std::vector<std::uint32_t> firstOfBin_;  // of its levels; and the end
    std::vector<LevelStep> leafy_, bare_;    // steps in and out of the leaf season
};

}  // namespace noonmark
