#include "core/review/criteria/spot_measure.h"

#include <algorithm>
#include <array>
#include <utility>

namespace noonmark {

int runsWanted(const Criterion& criterion) {
    const bool inParts = criterion.measure == Measure::share && criterion.spot.maxParts > 0;
    return inParts ? criterion.spot.maxParts : criterion.runs;
}

RunCounts countRuns(const Criterion& criterion, std::span<const std::uint32_t> lengths, double stepMin) {
    RunCounts runs;
    std::array<std::uint32_t, 8> top{};
    for (std::uint32_t length : lengths) {
        if (double(length) * stepMin < criterion.dropShorterMin * (1 - 1e-9)) continue;
        runs.total += length;
        runs.count += 1;
        for (std::uint32_t& place : top)
            if (length > place) std::swap(length, place);
    }
    runs.longest = top[0];
    for (int i = 0; i < runsWanted(criterion); ++i) runs.longestRuns += top[std::size_t(i)];
    return runs;
}

Measured measureSpot(const Criterion& criterion, const RunCounts& runs, const RunError& error) {
    const bool all = criterion.measure == Measure::spotTotal;
    const std::uint32_t steps = all                                            ? runs.total
                                : criterion.measure == Measure::spotLongestRun ? runs.longest
                                                                               : runs.longestRuns;
    const std::uint32_t uncertain = all ? runs.count : std::min(runs.count, std::uint32_t(criterion.runs));
    const double minutes = steps * error.stepMin, off = uncertain * error.runErrorMin;
    return {minutes, std::max(0.0, minutes - off), minutes + off};
}

bool meets(const SpotCondition& spot, const RunCounts& runs, const RunError& error, int sign) {
    constexpr double rounding = 1e-6;
    const double off = sign * error.runErrorMin;
    const double longest = runs.longest * error.stepMin + (runs.count > 0 ? off : 0) + rounding;
    const double total = runs.total * error.stepMin + runs.count * off + rounding;
    if ((spot.unbroken ? longest : total) >= spot.minutes) return true;
    if (spot.brokenMinutes <= 0 || longest < spot.partMinutes) return false;
    if (spot.maxParts == 0) return total >= spot.brokenMinutes;
    const std::uint32_t parts = std::min(runs.count, std::uint32_t(spot.maxParts));
    return runs.longestRuns * error.stepMin + parts * off + rounding >= spot.brokenMinutes;
}

}  // namespace noonmark
