#include "core/engines/points/horizons/point_runs.h"

#include <algorithm>
#include <bit>

namespace noonmark {

void widenHorizon(const BinHorizon& horizon, const SunBins& suns, BinHorizon& highest, BinHorizon& lowest) {
    constexpr int count = SunBins::count;
    for (BinHorizon* widened : {&highest, &lowest}) {
        widened->tan = horizon.tan;
        widened->firstGap.fill(0);
        widened->gaps.clear();
    }
    for (int bin = 0; bin < count; ++bin) {
        const auto own = std::size_t(bin);
        highest.tan[own] = horizon.topTan(own);
        for (const int other : {(bin + count - 1) % count, (bin + 1) % count}) {
            if (suns.empty(other)) continue;
            highest.tan[own] = std::max(highest.tan[own], horizon.topTan(std::size_t(other)));
            lowest.tan[own] = std::min(lowest.tan[own], horizon.tan[std::size_t(other)]);
        }
    }
}

PointRuns PointRunSearch::decide(const BinHorizon& horizon, const PointRunRays& rays) {
    widenHorizon(horizon, suns_, highest_, lowest_);
    const SunTrack::Longest found = track_.findLongest(horizon);
    ofShadow_ = true;
    const std::uint32_t shadow = longest(found.shadow, horizon, highest_, rays);
    ofShadow_ = false;
    return {shadow, longest(found.sun, horizon, lowest_, rays)};
}

// `most`: the horizon that gives the longest runs.
std::uint32_t PointRunSearch::longest(const TrackRun& found, const BinHorizon& horizon,
                                      const BinHorizon& most, const PointRunRays& rays) {
    const bool confirmed = holds(found, rays);
    longest_ = confirmed ? found.length() : 0;
    const std::uint32_t spare = confirmed ? std::uint32_t(allowed) : 0;
    for (const TrackRun& run : track_.findRuns(most, ofShadow_, longest_ + spare))
        if (run.length() > longest_) search(run, horizon, rays);
    return longest_;
}

// Whether the run is unbroken except for the number of steps that it may be off.
bool PointRunSearch::holds(const TrackRun& run, const PointRunRays& rays) {
    TrackRun rest = run;
    std::uint32_t unbroken = 0;
    for (std::uint32_t first = run.first; first < run.end; first += std::uint32_t(PointRunRays::together)) {
        steps_.clear();
        const auto end = std::min(run.end, first + std::uint32_t(PointRunRays::together));
        for (std::uint32_t step = first; step < end; ++step) steps_.push_back(step);
        const std::uint32_t shaded = rays.findShaded(steps_),
                            all = std::uint32_t((1ULL << steps_.size()) - 1);
        for (std::uint32_t left = (ofShadow_ ? ~shaded : shaded) & all; left != 0; left &= left - 1) {
            const std::uint32_t step = first + std::uint32_t(std::countr_zero(left));
            unbroken = std::max(unbroken, step - rest.first);
            rest.first = step + 1;
        }
        if (std::max(unbroken, rest.length()) + allowed < run.length()) return false;
    }
    return true;
}

// Raises longest_ to that of the steps of a run that may be unbroken.
void PointRunSearch::search(TrackRun run, const BinHorizon& horizon, const PointRunRays& rays) {
    while (run.length() > longest_) {
        const auto end = findEnd(run, horizon, rays);
        if (!end) {
            longest_ = run.length();
            return;
        }
        search({run.first, *end}, horizon, rays);
        run.first = *end + 1;
    }
}

// Looks for a step that ends the run: first where the horizon says so, then everywhere.
std::optional<std::uint32_t> PointRunSearch::findEnd(const TrackRun& run, const BinHorizon& horizon,
                                                     const PointRunRays& rays) {
    for (const bool likely : {true, false}) {
        collect(run, horizon, likely);
        if (const auto end = findEndAmongSteps(rays)) return end;
    }
    return std::nullopt;
}

// From the middle of the run outwards, since an end there leaves two runs too short to matter.
void PointRunSearch::collect(const TrackRun& run, const BinHorizon& horizon, bool likely) {
    steps_.clear();
    const auto add = [&](std::uint32_t step) {
        if ((track_.hides(horizon, step) != ofShadow_) == likely) steps_.push_back(step);
    };
    const std::uint32_t middle = run.first + run.length() / 2;
    for (std::uint32_t off = 0; off <= run.length() / 2; ++off) {
        if (middle + off < run.end) add(middle + off);
        if (off > 0) add(middle - off);
    }
}

std::optional<std::uint32_t> PointRunSearch::findEndAmongSteps(const PointRunRays& rays) const {
    for (std::size_t first = 0; first < steps_.size(); first += PointRunRays::together) {
        const std::span some =
            std::span(steps_).subspan(first, std::min(PointRunRays::together, steps_.size() - first));
        const std::uint32_t shaded = rays.findShaded(some), all = std::uint32_t((1ULL << some.size()) - 1);
        const std::uint32_t ends = (ofShadow_ ? ~shaded : shaded) & all;
        if (ends != 0) return some[std::size_t(std::countr_zero(ends))];
    }
    return std::nullopt;
}

}  // namespace noonmark
