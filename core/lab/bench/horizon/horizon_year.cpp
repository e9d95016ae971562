#include "core/lab/bench/horizon/horizon_bench.h"

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <glm/geometric.hpp>

#include "core/base/progress.h"
#include "core/engines/horizon/horizon_sweep.h"
#include "core/lab/bench/contests/contest.h"
#include "core/lab/bench/contests/moments.h"

namespace noonmark::bench {

namespace {

constexpr double yearHoursADay = 8;

/// A sweep and its settings.
struct Sweep {
    double binDeg;  ///< 0: determined by the error target
    bool runs;      ///< whether the longest runs are counted
    [[nodiscard]] const char* counted() const { return runs ? "gross, runs" : "gross"; }
    [[nodiscard]] std::string width() const { return binDeg > 0 ? fmt::format("{:g}", binDeg) : "by error"; }
};

// Gross shadow at all bin widths, and with the longest runs at the default one.
std::vector<Sweep> sweepsOf(const Extent& extent) {
    std::vector<Sweep> sweeps{{0, false}, {0, true}};
    for (const double binDeg : extent.binsDeg) sweeps.push_back({binDeg, false});
    return sweeps;
}

Result<std::vector<Contestant>> contestantsOf(std::span<const Sweep> sweeps, const EngineList& engines) {
    std::vector<Contestant> contestants;
    for (const Sweep& sweep : sweeps) {
        auto made = makeEngine("horizon", {{"bin", sweep.binDeg}, {"runs", sweep.runs ? 1 : 0}}, engines);
        if (!made) return tl::make_unexpected(made.error());
        contestants.push_back({"horizon", "Horizon sweep",
                               fmt::format("bin {}, {}", sweep.width(), sweep.counted()), std::move(*made)});
    }
    return contestants;
}

void addPoints(Finding& finding, double binDeg, const Placing& placing) {
    finding.charts[0].series[0].points.push_back({binDeg, placing.error.cellMeanPct, {}});
    finding.charts[0].series[1].points.push_back({binDeg, placing.error.cellP99Pct, {}});
    finding.charts[0].series[2].points.push_back({binDeg, placing.error.cellMaxPct, {}});
    finding.charts[1].series[0].points.push_back({1 / binDeg, placing.medianS, {}});
}

void addTo(Finding& finding, const Sweep& sweep, const Placing& placing, double raySeconds) {
    TableCell seconds, ratio;
    if (placing.timed()) {
        seconds = placing.medianS;
        ratio = raySeconds / placing.medianS;
        if (sweep.binDeg > 0) addPoints(finding, sweep.binDeg, placing);
    }
    finding.table.rows.push_back({sweep.binDeg, std::string(sweep.counted()), placing.error.cellMeanPct,
                                  placing.error.cellP99Pct, placing.error.cellMaxPct, seconds,
                                  double(placing.runs), ratio, placing.refusal});
    finding.comparisons[0].rows.push_back(
        {sweep.width(), sweep.counted(), fmt::format("{:.4f}", placing.error.cellMeanPct),
         fmt::format("{:.3f}", placing.error.cellMaxPct),
         placing.timed() ? formatThreeDigits(placing.medianS) : "",
         placing.timed() ? formatThreeDigits(raySeconds / placing.medianS) : ""});
    if (sweep.binDeg > 0 || !placing.timed()) return;
    if (sweep.runs) {
        finding.summary["year_with_runs_vs_ray"] = raySeconds / placing.medianS;
        return;
    }
    finding.summary["year_vs_ray"] = raySeconds / placing.medianS;
    finding.summary["year_cell_error_mean_pct"] = placing.error.cellMeanPct;
    finding.summary["year_cell_error_max_pct"] = placing.error.cellMaxPct;
}

Finding emptyFinding(const Extent& extent, double raySeconds) {
    Finding finding;
    finding.key = "horizon_year";
    finding.title = "A year by the horizon sweep";
    finding.text = fmt::format(
        "A year of 8 h days at every minute in the middle of the city. Errors of gross shadow against the "
        "ray reference at {} receivers, of the sunlit time; the ray reference's time for all, {} s, is "
        "extrapolated from them: it includes the longest runs, which cost it almost nothing. Medians of {} "
        "runs. A bin of 0 deg means the usual error target, {:g} %. All suns of a bin are taken at their "
        "mean azimuth: cells whose horizon ends within a bin, at the corner of a tower, have the largest "
        "errors.",
        extent.sampleReceivers, formatThreeDigits(raySeconds), extent.runs,
        HorizonSweepSettings{}.errorTargetPercent);
    finding.table.columns = {"bin_deg",
                             "counted",
                             "cell_error_mean_pct",
                             "cell_error_p99_pct",
                             "cell_error_max_pct",
                             "time_s",
                             "runs",
                             "times_ray",
                             "refusal"};
    finding.comparisons[0].header = {"bin, deg",   "counted", "error, mean, %",
                                     "largest, %", "time, s", "x rays"};
    finding.charts = {
        {"Error by bin width",
         {"bin, deg", true},
         {"cell error, % of the year", true},
         {{"mean", "ours"}, {"99 of 100 cells", "edge"}, {"largest", "most"}}},
        {"Time by number of bins", {"bins per degree", true}, {"time, s", true}, {{"time", "ours"}}}};
    return finding;
}

}  // namespace

Result<Finding> benchHorizonYear(const BenchSite& site, const Extent& extent, const EngineList& engines,
                                 const Work& work) {
    work.progress.report(0, "a year by the horizon sweep");
    const auto receivers = pickMiddleReceivers(site, work.stop);
    if (!receivers) return tl::make_unexpected(receivers.error());
    const auto sun = computeYearSun(site, yearHoursADay);
    if (!sun) return tl::make_unexpected(sun.error());
    const Scene scene{site.city, *receivers, *sun};
    const auto truth = computeTruth(scene, sampleOf(*receivers, extent.sampleReceivers, site.seed), work);
    if (!truth) return tl::make_unexpected(truth.error());
    const std::vector<Sweep> sweeps = sweepsOf(extent);
    const auto contestants = contestantsOf(sweeps, engines);
    if (!contestants) return tl::make_unexpected(contestants.error());
    const auto placings = runContest(scene, *contestants, *truth, extent, work);
    if (!placings) return tl::make_unexpected(placings.error());
    const double raySeconds = secondsForAll(*truth, *receivers);
    Finding finding = emptyFinding(extent, raySeconds);
    for (std::size_t i = 0; i < sweeps.size(); ++i) addTo(finding, sweeps[i], (*placings)[i], raySeconds);
    return finding;
}

namespace {
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
    const auto sun = computeYearSun(site, yearHoursADay);
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
