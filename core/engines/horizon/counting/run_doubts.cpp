#include "core/engines/horizon/counting/run_doubts.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

namespace noonmark {

namespace {

// Two bins are neighbours if their means are no farther apart than this; the widest bin has 2 deg.
constexpr double neighboursDeg = 4;

bool areNeighbours(const AzimuthBin& a, const AzimuthBin& b) {
    static const double cosine = std::cos(neighboursDeg * 3.14159265358979323846 / 180);
    return glm::dot(a.away, b.away) > cosine;
}

constexpr std::int16_t mostSteps = std::numeric_limits<std::int16_t>::max();

int stepsAllowed(const SunSteps& sun) {
    std::uint32_t most = 0;
    for (const SunDay& day : sun.days) most = std::max(most, day.count);
    return std::max(1, int(most / 50));
}

}  // namespace

RunDoubts::RunDoubts(const SunSteps& sun, const BinnedSun& binned) : allowed_(stepsAllowed(sun)) {
    const std::size_t count = binned.bins.size();
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t before = (i + count - 1) % count, after = (i + 1) % count;
        const auto orItself = [&](std::size_t other) {
            return std::uint16_t(areNeighbours(binned.bins[i], binned.bins[other]) ? other : i);
        };
        neighbours_.push_back({orItself(before), orItself(after)});
    }
}

void RunDoubts::Horizons::of(std::size_t lane, RunSearch::Horizons& horizons) const {
    horizons.highest.resize(highest.size());
    horizons.lowest.resize(lowest.size());
    for (std::size_t bin = 0; bin < highest.size(); ++bin) {
        horizons.highest[bin] = highest[bin].values[lane];
        horizons.lowest[bin] = lowest[bin].values[lane];
    }
}

void RunDoubts::widen(std::span<const RunLanes> horizons, Horizons& widened) const {
    widened.highest.resize(horizons.size());
    widened.lowest.resize(horizons.size());
    for (std::size_t bin = 0; bin < horizons.size(); ++bin) {
        const std::int16_t *own = horizons[bin].values, *before = horizons[neighbours_[bin].before].values,
                           *after = horizons[neighbours_[bin].after].values;
        for (std::size_t lane = 0; lane < lanesPerPart; ++lane) {
            widened.highest[bin].values[lane] = std::max(own[lane], std::max(before[lane], after[lane]));
            widened.lowest[bin].values[lane] = std::min(own[lane], std::min(before[lane], after[lane]));
        }
    }
}

RunDoubts::Lanes RunDoubts::lanesInDoubt(const LongestRuns& runs, const Horizons& widened,
                                         const RunLanes& longest) const {
    RunLanes longer, shorter;
    for (std::size_t lane = 0; lane < lanesPerPart; ++lane) {
        longer.values[lane] = std::int16_t(std::min(longest.values[lane] + allowed_ + 1, int(mostSteps)));
        shorter.values[lane] = std::int16_t(std::max(longest.values[lane] - allowed_, 0));
    }
    return {runs.reached(widened.highest, longer), ~runs.reached(widened.lowest, shorter)};
}

}  // namespace noonmark
