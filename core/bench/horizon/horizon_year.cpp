#include "core/bench/horizon/horizon_year.h"

#include <fmt/format.h>

#include "core/bench/contests/contest.h"
#include "core/bench/contests/moments.h"
#include "core/engines/horizon/horizon_sweep.h"

namespace noonmark::bench {

namespace {

constexpr double hoursADay = 8;

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
    const auto sun = computeYearSun(site, hoursADay);
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

}  // namespace noonmark::bench
