#include "core/engines/horizon/counting/run_decider.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <numbers>

namespace noonmark {

namespace {

// Two bins are neighbours if their means are no farther apart than this; the widest bin has 2 deg.
constexpr double neighboursDeg = 4;
constexpr double turnRad = 2 * std::numbers::pi;

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
        azimuthsRad_.push_back(azimuth < 0 ? azimuth + turnRad : azimuth);
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
        for (const double turn : {-turnRad, 0.0, turnRad}) doubtFrom(seen.azimuthRad + turn);
    }
}

void RunDoubts::doubtLight(std::size_t lane, Horizons& widened) {
    for (RunLanes& bin : widened.highest) bin.values[lane] = everyHorizon;
}

namespace {

RunLanes highestOf(std::span<const RunLanes> days) {
    RunLanes highest;
    for (const RunLanes& day : days)
        for (std::size_t lane = 0; lane < lanesPerPart; ++lane)
            highest.values[lane] = std::max(highest.values[lane], day.values[lane]);
    return highest;
}

void copyLane(const PartRuns& of, const RunDoubts::Horizons& widened, std::size_t lane,
              RunSearch::Horizons& horizons) {
    const auto copy = [&](std::span<const RunLanes> from, std::vector<HorizonCode>& to) {
        to.resize(from.size());
        for (std::size_t bin = 0; bin < from.size(); ++bin) to[bin] = from[bin].values[lane];
    };
    copy(widened.highest, horizons.highest);
    copy(of.horizons, horizons.own);
    copy(widened.lowest, horizons.lowest);
}

/// The steps of a run that are still taken for hidden, after some were found lit one after the other.
class ShrinkingRun {
public:
    explicit ShrinkingRun(const StepRun& run) : rest_(run) {}
    void cutAt(std::uint32_t lit) {
        longest_ = std::max(longest_, int(lit - rest_.first));
        rest_.first = lit + 1;
    }
    [[nodiscard]] int longest() const { return std::max(longest_, rest_.length()); }

private:
    StepRun rest_;
    int longest_ = 0;
};

}  // namespace

void RunDecider::decide(const LongestRuns& runs, std::size_t part, std::uint64_t lanes, PartRuns& of,
                        Memory& memory) const {
    if (lanes == 0) return;
    doubts_.widen(of.horizons, of.filled, memory.widened);
    if (!rays_.openBelow().empty()) doubtOpen(part, lanes, memory);
    runs.ofEachDay(memory.widened.highest, memory.maximum);
    const RunLanes maximum = highestOf(memory.maximum);
    for (; lanes != 0; lanes &= lanes - 1) {
        const auto lane = std::size_t(std::countr_zero(lanes));
        std::int16_t& longest = of.found.longest.values[lane];
        const RunRays::Receiver rays = rays_.of(blocks_.cell(part * lanesPerPart + lane));
        const bool confirmed = holds(runs, lane, of, rays, memory);
        if (confirmed && maximum.values[lane] <= longest + RunDoubts::allowed) continue;
        copyLane(of, memory.widened, lane, memory.search.horizons());
        memory.search.begin(rays.forSearch(), runs.steps(), confirmed ? longest : 0);
        longest = std::int16_t(runs.searched(lane, memory.maximum, memory.search));
        rays_.countReceiver();
    }
}

void RunDecider::doubtOpen(std::size_t part, std::uint64_t lanes, Memory& memory) const {
    EyeBox eyes;
    for (; lanes != 0; lanes &= lanes - 1) {
        const auto lane = std::size_t(std::countr_zero(lanes));
        const glm::vec3 eye = rays_.positionOf(blocks_.cell(part * lanesPerPart + lane));
        eyes = {glm::min(eyes.low, eye), glm::max(eyes.high, eye)};
        if (std::ranges::any_of(rays_.openBelow(), [&](const OpenBelow& open) { return isIn(open, eye); }))
            RunDoubts::doubtLight(lane, memory.widened);
    }
    doubts_.doubt(rays_.openBelow(), eyes, memory.widened);
}

// Whether the run found is hidden except for the number of steps that a run may be off. Only steps in doubt
// are looked at, or all if runs are checked.
bool RunDecider::holds(const LongestRuns& runs, std::size_t lane, const PartRuns& of,
                       const RunRays::Receiver& rays, Memory& memory) const {
    const int length = of.found.longest.values[lane];
    if (length == 0) return true;
    const StepRun run = of.below[lane].length() > 0 ? of.below[lane]
                                                    : runs.run(of.horizons, lane, of.found.day[lane], length);
    memory.steps.clear();
    for (std::uint32_t step = run.first; step < run.end; ++step) {
        const StepPlace& place = runs.steps()[step].place;
        if (rays_.checkRuns() || memory.widened.lowest[place.bin].values[lane] <= place.sun)
            memory.steps.push_back(step);
    }
    ShrinkingRun hidden(run);
    for (std::size_t first = 0; first < memory.steps.size(); first += RunRays::together) {
        const std::size_t count = std::min(RunRays::together, memory.steps.size() - first);
        const std::span some = std::span(memory.steps).subspan(first, count);
        for (std::uint32_t lit = rays.findLit(some); lit != 0; lit &= lit - 1)
            hidden.cutAt(some[std::size_t(std::countr_zero(lit))]);
        if (hidden.longest() < length - RunDoubts::allowed) return false;
    }
    return true;
}

}  // namespace noonmark
