#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "core/engines/common/open_below.h"
#include "core/engines/horizon/counting/longest_runs.h"
#include "core/engines/horizon/counting/walk_steps.h"
#include "core/engines/horizon/geometry/receiver_blocks.h"

namespace noonmark {

/// Horizons of 64 receivers at the mean of a bin, and at those of its neighbours.
struct HorizonsBeside {
    const RunLanes &before, &own, &after;
};

/// Shares of the tangents before and after a bin in that of an edge which runs through all three.
struct EdgeShares {
    float before = 0, after = 0;  ///< both 0: never on one edge
};

/// The highest of the three.
void findHighest(const HorizonsBeside& of, RunLanes& highest);

/// Bounds where the three do not lie on one edge, within the rounding of codes: `lowest` is noHorizon there,
/// and else the lowest of the three; `highest`, unless null, becomes everyHorizon there, and else stays.
void boundOffEdge(const HorizonsBeside& of, const EdgeShares& shares, RunLanes& lowest, RunLanes* highest);
inline constexpr HorizonCode everyHorizon = std::numeric_limits<HorizonCode>::max();  ///< hides every sun

/// Determines which steps of a longest run may be wrong because all suns of a bin are placed at the bin's
/// mean azimuth. Between two neighbouring means a horizon is known only if one edge makes it: seen from a
/// receiver, the tangent of a straight edge is a sine of the azimuth, so three neighbouring horizons of one
/// edge lie on one. Where they do not, an occluder ends or another begins, and there may be a gap between
/// them that no mean sees. Therefore a sun is
/// - certainly hidden if the horizons of its bin and of both neighbours hide it and lie on one edge;
/// - certainly lit if none of these horizons hides it and, at steps of more than a minute or so, where a
///   single one may part a run, they lie on one edge;
/// - in doubt otherwise, and where a part hides it below which there is open air (open_below.h).
/// Rays decide the doubts where they matter (RunDecider). Not detected: a gap between two occluders whose
/// tops are in one line to some millimetres, and a post narrower than a bin that stands free between two
/// means. Immutable.
class RunDoubts {
public:
    RunDoubts(const BinnedSun& binned, double stepMinutes);

    /// For each bin, the highest horizon of the bin and its neighbours, and the lowest; noHorizon where these
    /// do not lie on one edge.
    struct Horizons {
        std::vector<RunLanes> highest, lowest;
    };
    /// `horizons`: those of standing obstacles. `filled`: the same where there are no overhangs above them,
    /// else with the space below these filled.
    void widen(std::span<const RunLanes> horizons, std::span<const RunLanes> filled, Horizons& widened) const;

    /// Puts in doubt what parts with open air below hide from any of these eyes, unless something hides it
    /// that stands higher than the part. `widened`: from widen().
    void doubt(std::span<const OpenBelow> open, const EyeBox& eyes, Horizons& widened) const;
    /// Puts in doubt all that is lit as seen by one lane.
    static void doubtLight(std::size_t lane, Horizons& widened);

    /// Number of steps by which a longest run may be off.
    static constexpr int allowed = 2;

private:
    struct Neighbours {
        std::size_t before, after;  // the bin itself if the sun visits no bin beside it
        EdgeShares shares;
    };
    static Neighbours neighboursOf(const BinnedSun& binned, std::size_t bin);

    std::vector<Neighbours> neighbours_;  // one per bin
    std::vector<double> azimuthsRad_;     // of the means, ascending from north
    double widestRad_;                    // of the bins
    bool doubtsLight_;
};

/// What the horizons of a part say, and the runs that they give.
struct PartRuns {
    std::span<const RunLanes> horizons, filled;  ///< as RunDoubts::widen() takes them; one entry per bin
    LongestRuns::Found found;
    std::array<StepRun, lanesPerPart> below{};  ///< runs of lanes below overhangs; empty: that of `found`
};

/// Uses rays to confirm longest runs where horizons leave their steps in doubt (RunDoubts), and to search
/// those that are not confirmed or may be longer. For the receivers of one tile.
class RunDecider {
public:
    /// All arguments must outlive it.
    RunDecider(const RunDoubts& doubts, RunRays& rays, const ReceiverBlocks& blocks)
        : doubts_(doubts), rays_(rays), blocks_(blocks) {}

    /// Working memory, one per thread.
    struct Memory {
        RunDoubts::Horizons widened;
        std::vector<RunLanes> maximum;  // one per day
        std::vector<std::uint32_t> steps;
        RunSearch search;
    };
    /// Corrects the runs of the numbers [64 part, 64 part + 64). Bit k of `lanes`: lane k is to be examined.
    /// Afterwards runs are off by at most RunDoubts::allowed steps, as far as doubts are known. Costs as much
    /// as finding the runs, and some rays for each run.
    void decide(const LongestRuns& runs, std::size_t part, std::uint64_t lanes, PartRuns& of,
                Memory& memory) const;

private:
    void doubtOpen(std::size_t part, std::uint64_t lanes, Memory& memory) const;
    [[nodiscard]] bool holds(const LongestRuns& runs, std::size_t lane, const PartRuns& of,
                             const RunRays::Receiver& rays, Memory& memory) const;

    const RunDoubts& doubts_;
    RunRays& rays_;
    const ReceiverBlocks& blocks_;
};

}  // namespace noonmark
