#include "core/bench/horizon/horizon_scale.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>

#include "core/base/stopwatch.h"
#include "core/bench/contests/moments.h"
#include "core/engines/horizon/horizon_sweep.h"

namespace noonmark::bench {

namespace {

constexpr double hoursADay = 8;
constexpr std::array sidesOfWhole{0.125, 0.25, 0.5, 0.75, 1.0};
constexpr std::array buildingsOfWhole{0.0625, 0.125, 0.25, 0.5, 1.0};

Result<double> medianSeconds(const City& city, const Receivers& receivers, const SunSteps& sun,
                             const Extent& extent, const Work& work) {
    std::vector<double> seconds;
    NoProgress silent;
    for (int run = 0; run < extent.runs; ++run) {
        const Stopwatch watch;
        const auto field = HorizonSweep().accumulate(city, receivers, sun, silent, work.stop);
        if (!field) return tl::make_unexpected(field.error());
        seconds.push_back(watch.seconds());
        if (seconds.front() > extent.onceAboveS) break;
    }
    return computeMoments(seconds).median;
}

/// The share of the buildings that is nearest to the middle of the square.
City nearestOf(const BenchSite& site, double share) {
    const Box2 square = bounds(pickMiddleSquare(site.city, site.sideM));
    const glm::vec2 middle = (square.low + square.high) / 2.0F;
    const auto distance = [&](const auto& building) {
        const Box2 box = bounds(*building);
        return glm::distance((box.low + box.high) / 2.0F, middle);
    };
    City city = site.city;
    std::ranges::stable_sort(city.buildings, {}, distance);
    city.buildings.resize(std::max<std::size_t>(1, std::size_t(share * double(city.buildings.size()))));
    return city;
}

Result<void> addPoint(Finding& finding, std::size_t chart, double x, const Result<double>& seconds) {
    if (!seconds) return tl::make_unexpected(seconds.error());
    finding.charts[chart].series[0].points.push_back({x, *seconds, {}});
    finding.table.rows.push_back({finding.charts[chart].x.label, x, *seconds});
    return {};
}

Result<void> addSides(Finding& finding, const BenchSite& site, const SunSteps& sun, const Extent& extent,
                      const Work& work) {
    for (const double share : sidesOfWhole) {
        const auto receivers =
            placeReceiversOnGround(site.city, pickMiddleSquare(site.city, share * site.sideM), {}, work.stop);
        if (!receivers) return tl::make_unexpected(receivers.error());
        if (receivers->cells.empty()) continue;
        if (const auto done = addPoint(finding, 0, double(receivers->cells.size()),
                                       medianSeconds(site.city, *receivers, sun, extent, work));
            !done)
            return done;
    }
    return {};
}

// The same receivers for every share of the city: with the nearest buildings first, those in the square are
// always there.
Result<void> addBuildings(Finding& finding, const BenchSite& site, const SunSteps& sun, const Extent& extent,
                          const Work& work) {
    const auto receivers = pickMiddleReceivers(site, work.stop);
    if (!receivers) return tl::make_unexpected(receivers.error());
    for (const double share : buildingsOfWhole) {
        const City city = nearestOf(site, share);
        if (const auto done = addPoint(finding, 1, double(city.buildings.size()),
                                       medianSeconds(city, *receivers, sun, extent, work));
            !done)
            return done;
    }
    return {};
}

void addGrowth(Finding& finding) {
    for (const Chart& chart : finding.charts) {
        const auto& points = chart.series[0].points;
        if (points.size() < 2) continue;
        finding.comparisons[0].rows.push_back({chart.x.label,
                                               formatThreeDigits(points.back().x / points.front().x),
                                               formatThreeDigits(points.back().y / points.front().y)});
    }
}

}  // namespace

Result<Finding> benchHorizonScale(const BenchSite& site, const Extent& extent, const Work& work) {
    work.progress.report(0, "growth of the horizon sweep");
    const auto sun = computeYearSun(site, hoursADay);
    if (!sun) return tl::make_unexpected(sun.error());
    Finding finding;
    finding.key = "horizon_scale";
    finding.title = "Growth of the horizon sweep";
    finding.text =
        "A year of 8 h days at every minute: over squares of increasing size in the middle of the city, and "
        "over the whole square with an increasing share of the city's buildings, the nearest first.";
    finding.table.columns = {"grows", "count", "time_s"};
    finding.comparisons[0].header = {"", "times as many", "times as long"};
    finding.charts = {{"Time by receivers", {"receivers", true}, {"time, s", true}, {{"time", "ours"}}},
                      {"Time by buildings", {"buildings", true}, {"time, s", true}, {{"time", "ours"}}}};
    if (const auto done = addSides(finding, site, *sun, extent, work); !done)
        return tl::make_unexpected(done.error());
    if (const auto done = addBuildings(finding, site, *sun, extent, work); !done)
        return tl::make_unexpected(done.error());
    addGrowth(finding);
    return finding;
}

}  // namespace noonmark::bench
