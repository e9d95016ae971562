#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/bench/contests/contestant.h"
#include "core/bench/contests/field_error.h"
#include "core/bench/extent.h"
#include "core/bench/work.h"

namespace noonmark::bench {

/// What the engines are given.
struct Scene {
    const City& city;
    const Receivers& receivers;
    const SunSteps& sun;
};

/// The truth to hold results against, at all receivers or at a sample of them.
struct Truth {
    ShadowField field;
    Receivers receivers;
};

/// How one contestant did.
struct Placing {
    FieldError error;
    double medianS = 0;      ///< wall time from city to field, seconds
    int runs = 0;            ///< of the median; 0: there is no time
    std::string refusal;     ///< why there is no result, or none that may be timed; empty if all is well
    bool estimated = false;  ///< the time was worked out from a part of the receivers or of the days
    bool tooSlow = false;    ///< the refusal: it was stopped after Extent::neverAboveS, or left out
    std::optional<std::uint64_t> peakBytes{};  ///< of the run that was checked (peak_memory.h)
    [[nodiscard]] bool timed() const { return runs > 0; }
};

/// What check and runs took, seconds; endless where it was too slow.
double measureCost(const Placing& placing);

/// A result that is farther off than this is taken as wrong, and not timed: percent of the period, mean over
/// the cells.
constexpr double wrongAbovePct = 5;

/// Each contestant runs once and is held against the truth; those that pass then run in turn, round after
/// round. Extent::runs, onceAboveS and neverAboveS apply, the last not to those that are needed. An engine
/// that refuses the scene takes no part; cancelled() is an error. Placings in the order of the contestants.
Result<std::vector<Placing>> runContest(const Scene& scene, std::span<const Contestant> contestants,
                                        const Truth& truth, const Extent& extent, const Work& work);

/// The same of those contestants that fit into `seconds` together, the cheapest first; the others are left
/// out. `costs`: what each is expected to take.
Result<std::vector<Placing>> runContestWithin(double seconds, const std::vector<double>& costs,
                                              const Scene& scene, std::span<const Contestant> contestants,
                                              const Truth& truth, const Extent& extent, const Work& work);

/// The ray reference's answer.
Result<Truth> computeTruth(const Scene& scene, const Receivers& receivers, const Work& work);

/// The ray reference's time for all of `receivers`, from what `truth` of a sample took: its stage "trace"
/// grows with them, its other stages do not.
double secondsForAll(const Truth& truth, const Receivers& receivers);

}  // namespace noonmark::bench
