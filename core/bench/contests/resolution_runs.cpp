#include "core/bench/contests/resolution_runs.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace noonmark::bench {

namespace {

constexpr double growth = 3;  // four times the cells, but part of the work does not grow with them
constexpr std::size_t inAnyCase = 2;

// The share of the next run in the remaining time: the last of `toCome` runs takes more than all before it.
double shareOfNext(std::size_t toCome) { return (growth - 1) / (std::pow(growth, double(toCome)) - 1); }

Result<ResolutionRun> runAt(int resolution, const std::vector<double>& costs, double seconds,
                            const BenchSite& site, const Extent& extent, const StartList& engines,
                            const Work& work) {
    const auto receivers = placeReceiversAt(site, resolution, work.stop);
    if (!receivers) return tl::make_unexpected(receivers.error());
    const auto sun = makeNoonHour(site);
    if (!sun) return tl::make_unexpected(sun.error());
    const Scene scene{site.city, *receivers, *sun};
    const auto truth = computeTruth(scene, *receivers, work);
    if (!truth) return tl::make_unexpected(truth.error());
    return runContestWithin(seconds, costs, scene, engines.contestants, *truth, extent, work)
        .map([&](std::vector<Placing> placings) {
            return ResolutionRun{resolution, std::move(placings)};
        });
}

}  // namespace

std::string unlessAt(int finest, double cellsASide) {
    return cellsASide == finest ? "" : fmt::format(" at {:g}", cellsASide);
}

Result<std::vector<ResolutionRun>> benchResolutions(const BenchSite& site, const Extent& extent,
                                                    const StartList& engines, const Work& work) {
    if (extent.resolutions.empty()) return failure("No resolution is possible for a square of this size");
    std::vector<double> costs(engines.contestants.size(), 0);
    std::vector<ResolutionRun> runs;
    Pieces pieces(work, "time and memory by resolution", extent.resolutions.size());
    for (const int resolution : extent.resolutions) {
        pieces.next();
        const double share = shareOfNext(extent.resolutions.size() - runs.size());
        const double left = std::max(0.0, work.allowance.leftS()) * share;
        auto run = runAt(resolution, costs, left, site, extent, engines, work);
        if (!run) return tl::make_unexpected(run.error());
        runs.push_back(std::move(*run));
        for (std::size_t i = 0; i < costs.size(); ++i)
            if (runs.size() >= inAnyCase) costs[i] = growth * measureCost(runs.back().placings[i]);
    }
    return runs;
}

}  // namespace noonmark::bench
