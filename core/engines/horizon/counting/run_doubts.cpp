#include "core/engines/horizon/counting/run_doubts.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace noonmark {

namespace {

// Two bins are neighbours if their means are no farther apart than this; the widest bin has 2 deg.
constexpr double neighboursDeg = 4;

// In longer steps the sun passes what three bins see, so that one step taken for lit can part a run.
constexpr double minutesOfManySteps = 1.5;

bool areNeighbours(const AzimuthBin& a, const AzimuthBin& b) {
    static const double cosine = std::cos(neighboursDeg * 3.14159265358979323846 / 180);
    return glm::dot(a.away, b.away) > cosine;
}

double sineBetween(const AzimuthBin& a, const AzimuthBin& b) {
    return a.away.x * b.away.y - a.away.y * b.away.x;
}

}  // namespace

RunDoubts::RunDoubts(const BinnedSun& binned, double stepMinutes)
    : doubtsLight_(stepMinutes > minutesOfManySteps) {
    for (std::size_t bin = 0; bin < binned.bins.size(); ++bin)
        neighbours_.push_back(neighboursOf(binned, bin));
}

RunDoubts::Neighbours RunDoubts::neighboursOf(const BinnedSun& binned, std::size_t bin) {
    const std::size_t count = binned.bins.size(), before = (bin + count - 1) % count,
                      after = (bin + 1) % count;
    const auto orItself = [&](std::size_t other) {
        return areNeighbours(binned.bins[bin], binned.bins[other]) ? other : bin;
    };
    const std::size_t a = orItself(before), b = orItself(after);
    Neighbours beside{a, b, {}};
    if (a == bin || b == bin || a == b) return beside;
    const double whole = sineBetween(binned.bins[a], binned.bins[b]);
    beside.shares = {float(sineBetween(binned.bins[bin], binned.bins[b]) / whole),
                     float(sineBetween(binned.bins[a], binned.bins[bin]) / whole)};
    return beside;
}

void RunDoubts::widen(std::span<const RunLanes> horizons, std::span<const RunLanes> filled,
                      Horizons& widened) const {
    widened.highest.resize(horizons.size());
    widened.lowest.resize(horizons.size());
    for (std::size_t bin = 0; bin < horizons.size(); ++bin) {
        const auto& [before, after, shares] = neighbours_[bin];
        findHighest({filled[before], filled[bin], filled[after]}, widened.highest[bin]);
        boundOffEdge({horizons[before], horizons[bin], horizons[after]}, shares, widened.lowest[bin],
                     doubtsLight_ ? &widened.highest[bin] : nullptr);
    }
}

}  // namespace noonmark
