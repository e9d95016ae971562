#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "core/engines/horizon/counting/period_count.h"
#include "core/engines/horizon/counting/walk_steps.h"
#include "core/engines/horizon/geometry/receiver_blocks.h"
#include "core/engines/horizon/trees/crown_sweep.h"

namespace noonmark {

/// Where crowns take at least TreeShade::defaultShadedFrom of the sun from the cells of a tile, for longest
/// runs: for each bin, and each number of a block. Threads may set those of different bins or blocks at the
/// same time. Memory: up to 8 bytes for each bin and cell near trees.
class CrownMarks {
public:
    /// Of the cells of a block, 16 a row.
    struct Block {
        alignas(64) DarkLevels inLeaf[ReceiverBlocks::cells], bare[ReceiverBlocks::cells];
        bool anyInLeaf = false, anyBare = false;
    };

    void begin(std::size_t bins, const ReceiverBlocks& blocks);
    void set(std::size_t bin, std::size_t block, bool swapped, const Block& marks);

    /// Those of the 64 numbers of a part, in leaf and bare; null halves: none.
    struct Part {
        const DarkLevels* inLeaf[2] = {};
        const DarkLevels* bare[2] = {};
    };
    [[nodiscard]] Part of(std::size_t bin, std::size_t part) const;

private:
    struct Entry {
        std::unique_ptr<DarkLevels[]> inLeaf, bare;  ///< one per number of the block, padding included
    };
    [[nodiscard]] std::unique_ptr<DarkLevels[]> copyMarks(std::size_t block, bool swapped,
                                                          const DarkLevels* of) const;

    const ReceiverBlocks* blocks_ = nullptr;
    std::vector<Entry> entries_;              // bin by bin
    std::vector<std::uint32_t> blockOfHalf_;  // of 32 numbers
};

/// Longest runs in the shade of crowns and buildings, in steps: a step is in shade where its horizon or an
/// overhang hides it or crowns take TreeShade::defaultShadedFrom of the sun. Immutable.
///
/// Error: crowns are looked at from the mean azimuth of each bin's group, in up to CrownSweep::maxLevels
/// altitudes; between two altitudes their share is taken from a straight line, and below the lowest and above
/// the highest that of the nearest.
class CrownRunCount {
public:
    /// `steps` are those of the period, `inLeaf` one for each.
    CrownRunCount(const CrownSweep& sweep, std::span<const TimedStep> steps,
                  std::span<const std::uint8_t> inLeaf);

    /// Working memory; one per thread.
    struct Memory {
        std::vector<SpanLanes> inLeaf, bare;  // of each bin and span
        std::vector<DarkSpan> made;
        GapsByBin gaps;  // of a lane
    };
    struct Runs {
        RunLanes evergreen, seasonal;
    };
    /// `plain`: the horizons of a part with their gaps, as RunCount has left them; `decided`: their longest
    /// runs after rays. Where crowns make no run longer it stays that of `decided`, and none is shorter.
    [[nodiscard]] Runs of(const RunMemory& plain, const CrownMarks& marks, std::size_t part,
                          const RunLanes& decided, Memory& memory) const;

private:
    bool findLanes(std::span<const RunLanes> horizons, const CrownMarks& marks, std::size_t part,
                   Memory& memory) const;
    void addLanes(std::size_t bin, const RunLanes& horizon, const DarkLevels* const* halves, Memory& memory,
                  std::vector<SpanLanes>& to) const;
    [[nodiscard]] Runs walk(const Memory& memory) const;
    void walkBelowOverhangs(const RunMemory& plain, const Runs& maximum, Memory& memory, Runs& runs) const;

    const CrownSweep& sweep_;
    std::vector<std::uint32_t> firstOfBin_;  // of its spans; and the end
    std::vector<std::uint32_t> binOfSpan_;
    std::vector<SpanStep> leafy_, bare_;  // steps in and out of the leaf season
};

}  // namespace noonmark
