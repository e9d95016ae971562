#include "core/lab/bench/paper/paper_bench.h"

#include <fmt/format.h>
#include <algorithm>
#include <map>
#include <set>

#include "core/lab/bench/contests/contest.h"
#include "core/lab/bench/contests/moments.h"
#include "core/lab/bench/finding.h"

namespace noonmark::bench {

namespace {

/// The contest of all engines at one place on one day.
struct Meeting {
    int position = 0;
    CivilDate date;
    std::vector<Placing> placings;
};

/// `costs` and `seconds` as in runContestWithin().
Result<Meeting> meeting(const BenchSite& site, const Receivers& receivers, CivilDate date,
                        const std::vector<double>& costs, double seconds, const Extent& extent,
                        const StartList& engines, const Work& work) {
    const auto sun = computeSunOver(site, date, 1, extent.hoursADay);
    if (!sun) return tl::make_unexpected(sun.error());
    const Scene scene{site.city, receivers, *sun};
    const auto truth = computeTruth(scene, receivers, work);
    if (!truth) return tl::make_unexpected(truth.error());
    Extent patient = extent;
    patient.onceAboveS = std::numeric_limits<double>::infinity();
    return runContestWithin(seconds, costs, scene, engines.contestants, *truth, patient, work)
        .map([&](std::vector<Placing> placings) {
            return Meeting{0, date, std::move(placings)};
        });
}

/// Updates the costs with the times of the last contest that each engine took part in; engines of the first
/// contest always take part.
void note(std::vector<double>& costs, const Meeting& meeting) {
    for (std::size_t i = 0; i < costs.size(); ++i)
        if (meeting.placings[i].timed()) costs[i] = measureCost(meeting.placings[i]);
}

Result<std::vector<Meeting>> meetings(const BenchSite& site, const Extent& extent, const StartList& engines,
                                      const Work& work) {
    const std::vector<CivilDate> days = pickRandomDays(site, extent.days);
    std::vector<Meeting> all;
    Pieces pieces(work, "all engines, places and days", std::size_t(extent.positions) * days.size());
    std::vector<double> costs(engines.contestants.size(), 0);
    for (const Region& square : pickRandomSquares(site, extent.positions)) {
        const auto receivers = placeReceiversOnGround(site.city, square, {}, work.stop);
        if (!receivers) return tl::make_unexpected(receivers.error());
        for (std::size_t day = 0; day < days.size(); ++day) {
            pieces.next();
            const std::size_t runsLeft = std::size_t(extent.positions) * days.size() - all.size();
            auto one = meeting(site, *receivers, days[day], costs,
                               std::max(0.0, work.allowance.secondsLeft()) / double(runsLeft), extent,
                               engines, work);
            if (!one) return tl::make_unexpected(one.error());
            note(costs, *one);
            one->position = int(all.size() / days.size()) + 1;
            all.push_back(std::move(*one));
        }
    }
    return all;
}

/// Times of one engine in seconds per hour, where it was timed.
std::vector<double> secondsOf(std::size_t engine, const std::vector<Meeting>& all, double hours) {
    std::vector<double> seconds;
    for (const Meeting& one : all)
        if (one.placings[engine].timed()) seconds.push_back(one.placings[engine].medianS / hours);
    return seconds;
}

/// Mean time of `slow` divided by that of `fast`, over the contests where both were timed.
std::optional<double> ratioOf(std::string_view slow, std::string_view fast, const StartList& engines,
                              const std::vector<Meeting>& all) {
    const auto placeOf = [&](std::string_view key) {
        return std::size_t(std::ranges::find(engines.contestants, key, &Contestant::engine) -
                           engines.contestants.begin());
    };
    const std::size_t a = placeOf(slow), b = placeOf(fast);
    if (std::max(a, b) >= engines.contestants.size()) return {};
    double above = 0, below = 0;
    for (const Meeting& one : all) {
        if (!one.placings[a].timed() || !one.placings[b].timed()) continue;
        above += one.placings[a].medianS;
        below += one.placings[b].medianS;
    }
    return below > 0 ? std::optional(above / below) : std::nullopt;
}

void addRows(Finding& finding, const StartList& engines, const std::vector<Meeting>& all, double hours) {
    std::set<std::string> refusals;
    for (const Meeting& one : all)
        for (std::size_t i = 0; i < one.placings.size(); ++i) {
            const Placing& placing = one.placings[i];
            TableCell seconds;
            if (placing.timed()) seconds = placing.medianS / hours;
            finding.table.rows.push_back({engines.contestants[i].engine, double(one.position),
                                          formatText(one.date), seconds, double(placing.runs),
                                          placing.error.areaPct, placing.error.cellMeanPct, placing.refusal});
            if (!placing.refusal.empty())
                refusals.insert(engines.contestants[i].name + ": " + placing.refusal);
        }
    finding.remarks.assign(refusals.begin(), refusals.end());
}

void addEngines(Finding& finding, const StartList& engines, const std::vector<Meeting>& all, double hours) {
    for (std::size_t i = 0; i < engines.contestants.size(); ++i) {
        std::vector<double> seconds = secondsOf(i, all, hours);
        if (seconds.empty()) continue;
        std::ranges::sort(seconds);
        const Contestant& engine = engines.contestants[i];
        ChartSeries series{.name = engine.name, .colourOf = engine.engine, .marked = false};
        for (std::size_t rank = 0; rank < seconds.size(); ++rank)
            series.points.push_back({double(rank + 1), seconds[rank], {}});
        finding.charts[0].series.push_back(series);
        const auto ratio = ratioOf("ray", engine.engine, engines, all);
        finding.comparisons[0].rows.push_back({engine.name, formatThreeDigits(computeMoments(seconds).median),
                                               ratio ? formatThreeDigits(*ratio) : ""});
    }
}

void addRatio(Finding& finding, const char* key, const std::optional<double>& ratio, const char* what,
              const char* paper) {
    finding.comparisons[1].rows.push_back({what, ratio ? formatThreeDigits(*ratio) : "", paper});
    if (ratio) finding.summary[key] = std::max(*ratio, finding.summary[key]);
}

// The shadow accrual map has two forms; the summary uses the one that is faster on this machine.
void addAccrualRatios(Finding& finding, const StartList& engines, const std::vector<Meeting>& all) {
    addRatio(finding, "sam_vs_shadow_map", ratioOf("shadow-map-gl", "sam-gl", engines, all),
             "SAM in OpenGL / shadow maps", "> 10");
    addRatio(finding, "sam_vs_shadow_map", ratioOf("shadow-map-gl", "sam", engines, all),
             "SAM on the processor / shadow maps", "");
}

Finding emptyTimes(const Extent& extent) {
    Finding finding;
    finding.key = "engine_times";
    finding.title = "All engines over places and days";
    finding.text = fmt::format(
        "{} places, {} days of the year, {:g} h around noon at every minute. Times are from city to field, "
        "including everything that an engine builds; each is the median of {} runs, all engines in turn, "
        "after each engine's result was checked against rays. Every engine's times are sorted separately, as "
        "in the paper.",
        extent.positions, extent.days, extent.hoursADay, extent.runs);
    finding.table.columns = {
        "engine", "position", "date", "time_per_hour_s", "runs", "area_error_pct", "cell_error_mean_pct",
        "refusal"};
    finding.comparisons[0].header = {"engine", "s per hour", "x rays"};
    finding.charts = {{"Time for an hourly interval",
                       {.label = "place and day, sorted by time", .whole = true},
                       {"time for an hour of sun, s", true},
                       {}}};
    return finding;
}

/// All engines over random places and days (paper, section 7, Figure a of the performance evaluation):
/// Extent::hoursADay around noon, always Extent::runs runs, seconds per hourly interval, each engine's times
/// sorted separately. Summary: iam_vs_ray and sam_vs_shadow_map, the ratios of mean times if both were timed;
/// of the two forms of the shadow accrual map, the faster one on this machine.
Result<Finding> benchEngineTimes(const BenchSite& site, const Extent& extent, const StartList& engines,
                                 const Work& work) {
    const auto all = meetings(site, extent, engines, work);
    if (!all) return tl::make_unexpected(all.error());
    Finding finding = emptyTimes(extent);
    addRows(finding, engines, *all, extent.hoursADay);
    addEngines(finding, engines, *all, extent.hoursADay);
    finding.comparisons.push_back({{"times as fast", "ours", "paper"}, {}});
    addRatio(finding, "iam_vs_ray", ratioOf("ray", "iam", engines, *all), "IAM / rays", "5.3");
    addAccrualRatios(finding, engines, *all);
    return finding;
}

Finding makeFailedFinding(const char* title, const Error& error) {
    return {.title = title, .text = "This experiment failed: " + error.text(), .comparisons = {}};
}

std::string describeSite(const BenchSite& site) {
    return fmt::format("{}, {} buildings; {} and its year, {}", site.name, site.city.buildings.size(),
                       noonmark::formatText(site.date), site.zone);
}

}  // namespace

void Experiments::add(const char* title, const Make& make, double share) {
    if (work_.stopped()) return;
    shares_ += share;
    const Stopwatch watch;
    Result<Finding> finding =
        make({work_.progress, work_.stop, Allowance(shares_ * budgetS_ - watch_.seconds())});
    if (!finding && isCancelled(finding.error())) return;
    if (!finding) finding = makeFailedFinding(title, finding.error());
    finding->seconds = watch.seconds();
    findings_.push_back(std::move(*finding));
}

void Experiments::remark(const std::string& text) {
    if (!findings_.empty()) findings_.front().remarks.push_back(text);
}

Result<BenchReport> Experiments::into(BenchReport report, const BenchSite& site, const Extent& extent) && {
    if (work_.stopped()) return cancelled();
    report.site = describeSite(site);
    report.machine = describeMachine(detectMachine());
    report.extent = extent.words;
    for (const Finding& finding : findings_) report.seconds += finding.seconds;
    report.findings = std::move(findings_);
    fillSummary(report);
    return report;
}

Result<void> check(const BenchSite& site) {
    if (site.city.buildings.empty())
        return failure("There are no buildings to measure", site.name, "Choose a city with buildings");
    // Reports a wrong date or zone once, instead of in every experiment.
    return makeNoonHour(site).map([](const SunSteps&) {});
}

namespace {

std::vector<SummaryFigure> paperSummary() {
    return {{"sam_vs_shadow_map", "shadow accrual map, times as fast as shadow maps", "> 10"},
            {"iam_vs_ray", "inverse accrual map, times as fast as rays", "5.3"},
            {"iam_area_error_mean_pct", "inverse accrual map, area error, mean, %", "< 1"},
            {"iam_area_error_max_pct", "inverse accrual map, area error, largest, %", "2.6"},
            {"graph_edges", "direction graph, edges of a year", "299"},
            {"graph_intervals", "direction graph, hourly intervals of a year", "2190"},
            {"graph_area_error_mean_pct", "direction graph, area error, mean, %", "0.47"},
            {"graph_mistagged_pct", "direction graph, mistagged, %", "0.8"},
            {"year_graph_speedup", "a year by graph and inverse accrual map, times as fast as rays", "> 50"}};
}

void addPeriods(Experiments& experiments, const BenchSite& site, const Extent& extent,
                const EngineList& engines) {
    Result<std::vector<PeriodRun>> runs;
    const auto against = [&](const Work& work) {
        runs = benchPeriods(site, extent, engines, work);
        return runs.map([&](const auto& made) { return benchTimeAgainstError(made, extent); });
    };
    const auto byDays = [&](const Work&) {
        return runs.map([&](const auto& made) { return benchTimeByDays(made, extent); });
    };
    experiments.add("Run time against error", against, 0.42);
    experiments.add("Time by days", byDays, 0);
}

void addResolutions(Experiments& experiments, const BenchSite& site, const Extent& extent,
                    const StartList& engines) {
    Result<std::vector<ResolutionRun>> runs;
    const auto time = [&](const Work& work) {
        runs = benchResolutions(site, extent, engines, work);
        return runs.map([&](const auto& made) { return benchTimeByResolution(made, site, extent, engines); });
    };
    const auto memory = [&](const Work&) {
        return runs.map([&](const auto& made) { return benchMemoryByResolution(made, extent, engines); });
    };
    experiments.add("Time by resolution", time, 0.2);
    experiments.add("Memory by resolution", memory, 0);
}

void addAll(Experiments& experiments, const BenchSite& site, const Extent& extent,
            const EngineList& engines) {
    const StartList standard = listDefaultEngines(engines);
    addPeriods(experiments, site, extent, engines);
    experiments.add(
        "All engines over places and days",
        [&](const Work& work) { return benchEngineTimes(site, extent, standard, work); }, 0.25);
    addResolutions(experiments, site, extent, standard);
    experiments.add(
        "Inverse accrual map: error by source level",
        [&](const Work& work) { return benchLevelError(site, extent, engines, work); }, 0.07);
    experiments.add(
        "Shadows through the direction graph",
        [&](const Work& work) { return benchGraphError(site, extent, work); }, 0.04);
    experiments.add("The direction graph",
                    [&](const Work& work) { return benchGraphBound(site, extent, work); });
    experiments.add("How straight the sun's path is",
                    [&](const Work& work) { return benchSunLinearity(site, extent, work); });
    for (const std::string& absent : standard.absent) experiments.remark(absent);
}

}  // namespace

Result<BenchReport> runPaperBench(const BenchSite& site, const Extent& extent, const EngineList& engines,
                                  Progress& progress, const std::stop_token& stop) {
    if (const auto fits = check(site); !fits) return tl::make_unexpected(fits.error());
    const Work work{progress, stop};
    Extent fitting = extent;
    fitting.resolutions = chooseResolutions(site, extent.resolutions);
    Experiments experiments(work, extent.budgetS);
    addAll(experiments, site, fitting, engines);
    return std::move(experiments)
        .into({.title = "The paper's experiments, repeated", .summary = paperSummary()}, site, extent);
}

}  // namespace noonmark::bench
