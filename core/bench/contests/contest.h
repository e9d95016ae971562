#pragma once

// The folder core/bench/contests runs engines against each other. A Contestant is an engine with settings
// (contestant.h); a contest (this file) checks each against the ray reference (field_error.h) and then times
// it in rounds (moments.h). site.h says where and when; period_runs.h, resolution_runs.h and engine_times.h
// run contests over periods, resolutions and random positions. Time is limited by allowance.h, deadline.h and
// forecast.h; history.h predicts the time of longer periods. ray_masks.h traces directions that belong to no
// period.

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/bench/contests/contestant.h"
#include "core/bench/contests/field_error.h"
#include "core/bench/extent.h"
#include "core/bench/work.h"

namespace noonmark::bench {

/// The input of the engines.
struct Scene {
    const City& city;
    const Receivers& receivers;
    const SunSteps& sun;
};

/// The reference that results are compared with, at all receivers or at a sample of them.
struct Truth {
    ShadowField field;
    Receivers receivers;
};

/// The result of one contestant.
struct Placing {
    FieldError error;
    double medianS = 0;      ///< wall time from city to field, seconds
    int runs = 0;            ///< number of runs in the median; 0: not timed
    std::string refusal;     ///< why there is no result, or none that may be timed; empty if there is one
    bool estimated = false;  ///< the time was extrapolated from a part of the receivers or of the days
    /// The reason for the refusal: it was stopped after Extent::neverAboveS, or left out
    bool tooSlow = false;
    std::optional<std::uint64_t> peakBytes{};  ///< of the run that was checked (peak_memory.h)
    [[nodiscard]] bool timed() const { return runs > 0; }
};

/// Total time of the check and the runs, seconds; infinite if the contestant was too slow.
double measureCost(const Placing& placing);

/// A result with a larger error counts as wrong and is not timed: percent of the period, mean over the cells.
constexpr double wrongAbovePct = 5;

/// Each contestant runs once and is compared with the truth; those that pass then run in turn, round after
/// round. Extent::runs, onceAboveS and neverAboveS apply, except that neverAboveS does not apply to needed
/// contestants. An engine that refuses the scene takes no part; cancelled() is an error. Returns placings in
/// the order of the contestants.
Result<std::vector<Placing>> runContest(const Scene& scene, std::span<const Contestant> contestants,
                                        const Truth& truth, const Extent& extent, const Work& work);

/// Runs only those contestants that fit into `seconds` together, the cheapest first; the others are left out.
/// `costs`: expected seconds of each.
Result<std::vector<Placing>> runContestWithin(double seconds, const std::vector<double>& costs,
                                              const Scene& scene, std::span<const Contestant> contestants,
                                              const Truth& truth, const Extent& extent, const Work& work);

/// The result of the ray reference.
Result<Truth> computeTruth(const Scene& scene, const Receivers& receivers, const Work& work);

/// The ray reference's time for all of `receivers`, extrapolated from `truth` of a sample: its stage "trace"
/// is proportional to them, its other stages do not change.
double secondsForAll(const Truth& truth, const Receivers& receivers);

}  // namespace noonmark::bench
