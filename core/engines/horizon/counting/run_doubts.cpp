#include "core/engines/horizon/counting/run_doubts.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

namespace noonmark {

namespace {

// Two bins are neighbours if their means are no farther apart than this; the widest bin has 2 deg.
constexpr double neighboursDeg = 4;
constexpr double fullTurn = 2 * std::numbers::pi;

// In longer steps the sun passes what three bins see, so that one step taken for lit can part a run.
constexpr double minutesOfManySteps = 1.5;

bool areNeighbours(const AzimuthBin& a, const AzimuthBin& b) {
    static const double cosine = std::cos(neighboursDeg * std::numbers::pi / 180);
    return glm::dot(a.away, b.away) > cosine;
}

double sineBetween(const AzimuthBin& a, const AzimuthBin& b) {
    return a.away.x * b.away.y - a.away.y * b.away.x;
}

}  // namespace

RunDoubts::RunDoubts(const BinnedSun& binned, double stepMinutes)
    : widestRad_(binned.widestDeg * std::numbers::pi / 180), doubtsLight_(stepMinutes > minutesOfManySteps) {
    for (std::size_t bin = 0; bin < binned.bins.size(); ++bin) {
        neighbours_.push_back(neighboursOf(binned, bin));
        const double azimuth = std::atan2(-binned.bins[bin].away.x, -binned.bins[bin].away.y);
        azimuthsRad_.push_back(azimuth < 0 ? azimuth + fullTurn : azimuth);
    }
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

namespace {

// One level higher, which exceeds rounding.
HorizonCode codeAbove(double tan) {
    const double steepness = std::isinf(tan) ? 1 : tan / (1 + tan);
    return HorizonCode(std::min(int(toHorizonCode(float(steepness))) + 1, int(everyHorizon)));
}

}  // namespace

void RunDoubts::doubt(std::span<const OpenBelow> open, const EyeBox& eyes, Horizons& widened) const {
    for (const OpenBelow& one : open) {
        const SeenOpenBelow seen = seeFrom(one, eyes);
        if (seen.topTan <= 0) continue;
        const HorizonCode top = codeAbove(seen.topTan);
        const double half = std::min(seen.halfRad + widestRad_, std::numbers::pi);
        const auto doubtFrom = [&](double azimuth) {
            auto bin = std::ranges::lower_bound(azimuthsRad_, azimuth - half);
            for (; bin != azimuthsRad_.end() && *bin <= azimuth + half; ++bin)
                for (HorizonCode& code : widened.lowest[std::size_t(bin - azimuthsRad_.begin())].values)
                    if (code <= top) code = noHorizon;
        };
        for (const double turn : {-fullTurn, 0.0, fullTurn}) doubtFrom(seen.azimuthRad + turn);
    }
}

void RunDoubts::doubtLight(std::size_t lane, Horizons& widened) {
    for (RunLanes& bin : widened.highest) bin.values[lane] = everyHorizon;
}

}  // namespace noonmark
