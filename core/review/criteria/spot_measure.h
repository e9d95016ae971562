#pragma once

#include <cstdint>
#include <span>

#include "core/review/criteria/verdict.h"

namespace noonmark {

/// The runs of one spot in one day, in steps.
struct RunCounts {
    std::uint32_t total = 0;        ///< of all runs
    std::uint32_t longest = 0;      ///< the longest run
    std::uint32_t longestRuns = 0;  ///< the sum of the longest runs asked for
    std::uint32_t count = 0;        ///< number of runs
};

/// The length of a step, and how uncertain that of a run is.
struct RunError {
    double stepMin = 1;
    double runErrorMin = 1;  ///< minutes; of n runs n times as much
};

/// Of how many longest runs the sum is wanted: a criterion's own number, or the parts of a broken total.
int runsWanted(const Criterion& criterion);

/// Counts runs by their lengths in steps; those shorter than the criterion's `dropShorterMin` are left out.
RunCounts countRuns(const Criterion& criterion, std::span<const std::uint32_t> lengths, double stepMin);

/// The minutes of a criterion about the worst spot (Measure::spotTotal and the like), for the runs of that
/// spot.
Measured measureSpot(const Criterion& criterion, const RunCounts& runs, const RunError& error);

/// Whether a spot has what the condition asks for, with the length of its runs changed by `sign` times their
/// error. Of a broken total with a number of parts the longest parts count, whatever other sun follows.
bool meets(const SpotCondition& spot, const RunCounts& runs, const RunError& error, int sign);

}  // namespace noonmark
