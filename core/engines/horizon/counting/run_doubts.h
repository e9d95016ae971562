#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/engines/horizon/counting/longest_runs.h"

namespace noonmark {

/// Determines which longest runs may be wrong because all suns of a bin are placed at the bin's mean azimuth.
/// An occluder between a sun and that mean is missed, but it is usually seen at the mean of the neighbouring
/// bin on its other side. Therefore a sun is certainly hidden if the horizons of its bin and of both
/// neighbours hide it, certainly lit if none of them does, and in doubt otherwise. A run is in doubt if suns
/// in doubt could make it longer or shorter than allowed. Occluders narrower than a bin that lie between two
/// means are not detected. Immutable.
class RunDoubts {
public:
    RunDoubts(const SunSteps& sun, const BinnedSun& binned);

    /// For each bin, the highest and the lowest horizon of the bin and its neighbours.
    struct Horizons {
        std::vector<RunLanes> highest, lowest;
        void of(std::size_t lane, RunSearch::Horizons& horizons) const;
    };
    void widen(std::span<const RunLanes> horizons, Horizons& widened) const;

    /// Bit k: the longest run of lane k may be longer or shorter by more than allowed().
    struct Lanes {
        std::uint64_t mayBeLonger, mayBeShorter;
    };
    /// `widened`: from widen(). About as much work as finding the longest runs.
    [[nodiscard]] Lanes lanesInDoubt(const LongestRuns& runs, const Horizons& widened,
                                     const RunLanes& longest) const;

    /// Number of steps by which a longest run may be off without being reported as in doubt: 2 % of the
    /// longest day, at least one.
    [[nodiscard]] int allowed() const { return allowed_; }

private:
    struct Neighbours {
        std::uint16_t before, after;  // the bin itself if the sun visits no bin beside it
    };
    std::vector<Neighbours> neighbours_;  // one per bin
    int allowed_ = 1;                     // steps
};

}  // namespace noonmark
