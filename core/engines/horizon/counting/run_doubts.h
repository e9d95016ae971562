#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/engines/horizon/counting/longest_runs.h"

namespace noonmark {

/// Which longest runs may be wrong because all suns of a bin are taken at the bin's mean azimuth. What stands
/// between a sun and that mean is missed; but it is seen, as a rule, at the mean of the bin on its other
/// side. So a sun counts as surely hidden where the horizons of its bin and of both neighbours hide it, as
/// surely lit where none does, and as in doubt else. A run is in doubt where suns in doubt could make it
/// longer or shorter than allowed. What is narrower than a bin and stands between two means is not found.
/// Immutable.
class RunDoubts {
public:
    RunDoubts(const SunSteps& sun, const BinnedSun& binned);

    /// Of each bin the highest and the lowest horizon of itself and its neighbours.
    struct Horizons {
        std::vector<RunLanes> highest, lowest;
        void of(std::size_t lane, RunSearch::Horizons& horizons) const;
    };
    void widen(std::span<const RunLanes> horizons, Horizons& widened) const;

    /// Bit k: the longest run of lane k may be longer or shorter by more than allowed().
    struct Lanes {
        std::uint64_t mayBeLonger, mayBeShorter;
    };
    /// `widened`: as made by widen(). About as much work as finding the longest runs.
    [[nodiscard]] Lanes lanesInDoubt(const LongestRuns& runs, const Horizons& widened,
                                     const RunLanes& longest) const;

    /// Steps that a longest run may be off unseen: 2 % of the longest day, at least one.
    [[nodiscard]] int allowed() const { return allowed_; }

private:
    struct Neighbours {
        std::uint16_t before, after;  // itself where the sun visits none beside it
    };
    std::vector<Neighbours> neighbours_;  // of each bin
    int allowed_ = 1;                     // steps
};

}  // namespace noonmark
