#include "core/lab/bench/paper/paper_bench.h"

#include <fmt/format.h>
#include <algorithm>
#include <map>
#include <optional>
#include <set>

#include "core/lab/bench/contests/moments.h"

namespace noonmark::bench {

namespace {

struct DayTime {
    int days = 1;
    double seconds = 0;
    int runs = 0;
    bool estimated = false;
};

/// Shown are the engines with their usual settings, and the inverse accrual map without a graph.
bool isShown(const Contestant& contestant) {
    return contestant.setting.empty() || contestant.setting == withoutGraph;
}

/// Times of one contestant by days; extrapolated if it was too slow, nothing if it refused.
std::vector<DayTime> timesOf(const std::string& title, const std::vector<PeriodRun>& runs) {
    std::vector<DayTime> times;
    std::optional<DayTime> last;
    for (const PeriodRun& run : runs) {
        if (run.name == "an hour") continue;
        for (std::size_t i = 0; i < run.contestants.size(); ++i) {
            const Placing& placing = run.placings[i];
            if (makeTitle(run.contestants[i]) != title) continue;
            if (placing.timed()) {
                times.push_back({run.days, placing.medianS, placing.runs, placing.estimated});
                last = times.back();
            } else if (placing.tooSlow && last) {
                times.push_back({run.days, last->seconds * run.days / last->days, 0, true});
            }
        }
    }
    return times;
}

void addSeries(Finding& finding, const Contestant& contestant, const std::vector<DayTime>& times) {
    const std::string colour = contestant.engine + contestant.setting;
    ChartSeries measured{.name = makeTitle(contestant), .colourOf = colour};
    ChartSeries estimated{.name = makeTitle(contestant), .colourOf = colour, .estimated = true};
    for (const DayTime& time : times) {
        const ChartPoint point{double(time.days), time.seconds, {}};
        if (time.estimated && estimated.points.empty() && !measured.points.empty())
            estimated.points.push_back(measured.points.back());
        (time.estimated ? estimated : measured).points.push_back(point);
    }
    for (ChartSeries* series : {&measured, &estimated})
        if (!series->points.empty()) finding.charts[0].series.push_back(std::move(*series));
}

void addRows(Finding& finding, const Contestant& contestant, const std::vector<DayTime>& times) {
    for (const DayTime& time : times)
        finding.table.rows.push_back({contestant.engine, contestant.setting, double(time.days), time.seconds,
                                      double(time.runs), time.estimated ? "yes" : "no"});
}

std::string secondsText(const DayTime& time) {
    return fmt::format("{}{}", time.estimated ? "~" : "", formatThreeDigits(time.seconds));
}

using Times = std::map<std::string, std::vector<DayTime>>;

void addComparison(Finding& finding, const std::string& title, const Times& times) {
    const std::vector<DayTime>&mine = times.at(title), &rays = times.at("Ray reference");
    if (mine.empty() || rays.empty() || mine.back().days != rays.back().days) return;
    finding.comparisons[0].rows.push_back({title, secondsText(mine.front()), secondsText(mine.back()),
                                           formatThreeDigits(rays.back().seconds / mine.back().seconds)});
}

void addSpeedup(Finding& finding, const Times& times) {
    const auto iam = times.find("Inverse accrual map"), bare = times.find("Inverse accrual map, no graph"),
               ray = times.find("Ray reference");
    if (iam == times.end() || ray == times.end() || iam->second.empty() || ray->second.empty()) return;
    const DayTime &with = iam->second.back(), &rays = ray->second.back();
    if (with.days != 365 || rays.days != 365) return;
    if (!with.estimated) finding.summary["year_graph_speedup"] = rays.seconds / with.seconds;
    finding.comparisons.push_back(
        {{"a year with the graph", "ours", "paper"},
         {{"rays / IAM with graph", formatThreeDigits(rays.seconds / with.seconds), "> 50"}}});
    if (bare != times.end() && !bare->second.empty())
        finding.comparisons.back().rows.push_back(
            {"IAM without graph / with", formatThreeDigits(bare->second.back().seconds / with.seconds), ""});
}

Finding emptyScalingFinding(const Extent& extent) {
    Finding finding;
    finding.key = "time_by_days";
    finding.title = "Time by days";
    finding.text = fmt::format(
        "6 h a day from 9:00 at every minute, in the middle of the city, over increasing numbers of days. "
        "Hollow marks and dashed lines are extrapolated: the ray reference beyond one day from {} receivers, "
        "an engine that would take more than {:g} s in proportion to the days. Medians of {} runs if one "
        "takes less than {:g} s.",
        extent.sampleReceivers, extent.neverAboveS, extent.runs, extent.onceAboveS);
    finding.table.columns = {"engine", "setting", "days", "time_s", "runs", "estimated"};
    finding.comparisons[0].header = {"engine", "1 day, s", fmt::format("{} days, s", extent.dayCounts.back()),
                                     "x rays"};
    finding.charts = {{"Time for a period", {"days", true}, {"time, s", true}, {}}};
    return finding;
}

}  // namespace

Finding benchTimeByDays(const std::vector<PeriodRun>& runs, const Extent& extent) {
    Finding finding = emptyScalingFinding(extent);
    if (runs.empty()) return finding;
    Times times;
    for (const Contestant& contestant : runs.back().contestants) {
        if (!isShown(contestant)) continue;
        const std::vector<DayTime>& mine = times[makeTitle(contestant)] =
            timesOf(makeTitle(contestant), runs);
        addRows(finding, contestant, mine);
        addSeries(finding, contestant, mine);
    }
    for (const auto& [title, mine] : times) addComparison(finding, title, times);
    addSpeedup(finding, times);
    return finding;
}

namespace {

/// Smaller errors are drawn at this value, since a logarithmic axis has no zero. Percent.
constexpr double minShownPct = 1e-4;
/// The ray reference, which has no error, is drawn as a line from that value to this one.
constexpr double maxShownPct = 5;

void addRow(Finding& finding, const PeriodRun& run, std::size_t place) {
    const Contestant& contestant = run.contestants[place];
    const Placing& placing = run.placings[place];
    std::vector<TableCell> row{run.name, contestant.engine, contestant.setting};
    if (placing.timed())
        row.insert(row.end(), {placing.error.areaPct, placing.error.cellMeanPct, placing.error.cellP99Pct,
                               placing.error.cellMaxPct, placing.medianS, double(placing.runs)});
    else
        row.resize(row.size() + 6);
    row.insert(row.end(), {placing.estimated ? "yes" : "no", placing.refusal});
    finding.table.rows.push_back(std::move(row));
}

ChartSeries rayLine(const Contestant& ray, const Placing& placing) {
    return {.name = ray.name + " (no error)",
            .colourOf = ray.engine,
            .points = {{minShownPct, placing.medianS, {}}, {maxShownPct, placing.medianS, {}}},
            .marked = false,
            .estimated = placing.estimated};
}

/// Whether a setting gives the same result as the default: the bound of the graph on a single day.
bool changesNothing(const PeriodRun& run, std::size_t place) {
    if (run.contestants[place].setting.empty()) return false;
    for (std::size_t i = 0; i < place; ++i)
        if (run.contestants[i].engine == run.contestants[place].engine && run.placings[i].timed() &&
            run.placings[i].error == run.placings[place].error)
            return true;
    return false;
}

void addPoint(Chart& chart, const PeriodRun& run, std::size_t place) {
    const Contestant& contestant = run.contestants[place];
    const Placing& placing = run.placings[place];
    if (!placing.timed() || changesNothing(run, place)) return;
    if (contestant.engine == "ray") {
        chart.series.push_back(rayLine(contestant, placing));
        return;
    }
    auto series = std::ranges::find(chart.series, contestant.name, &ChartSeries::name);
    if (series == chart.series.end())
        series = chart.series.insert(
            series, {.name = contestant.name, .colourOf = contestant.engine, .joined = false});
    series->points.push_back(
        {std::max(minShownPct, placing.error.cellMeanPct), placing.medianS, contestant.setting});
}

Chart chartOf(const PeriodRun& run) {
    Chart chart{run.name, {"cell error, mean, % of the period", true}, {"time, s", true}, {}};
    chart.title[0] = char(std::toupper(chart.title[0]));
    for (std::size_t i = 0; i < run.contestants.size(); ++i) addPoint(chart, run, i);
    return chart;
}

void addRefusals(Finding& finding, const std::vector<PeriodRun>& runs) {
    std::set<std::string> refusals;
    for (const PeriodRun& run : runs)
        for (std::size_t i = 0; i < run.placings.size(); ++i)
            if (!run.placings[i].refusal.empty() && !run.placings[i].tooSlow && !run.name.empty())
                refusals.insert(makeTitle(run.contestants[i]) + ": " + run.placings[i].refusal);
    finding.remarks.assign(refusals.begin(), refusals.end());
}

Finding emptyErrorFinding(const Extent& extent) {
    Finding finding;
    finding.key = "time_against_error";
    finding.title = "Run time against error";
    finding.text = fmt::format(
        "Every engine and setting: an hour from noon, and days of 6 h from 9:00, at every minute, in the "
        "middle of the city. Error is the mean over the cells of the difference of gross shadow from the ray "
        "reference, of the sunlit time, drawn at {:g} % or more; over a month and a year on {} receivers. A "
        "point without a label is an engine with its usual settings; settings that change nothing are not "
        "drawn; the line is the ray reference, dashed where its time is extrapolated from those receivers. "
        "Runs of more than {:g} s are left out. Down and to the left is better.",
        minShownPct, extent.sampleReceivers, extent.neverAboveS);
    finding.table.columns = {"period",
                             "engine",
                             "setting",
                             "area_error_pct",
                             "cell_error_mean_pct",
                             "cell_error_p99_pct",
                             "cell_error_max_pct",
                             "time_s",
                             "runs",
                             "estimated",
                             "refusal"};
    finding.comparisons.clear();
    return finding;
}

}  // namespace

Finding benchTimeAgainstError(const std::vector<PeriodRun>& runs, const Extent& extent) {
    Finding finding = emptyErrorFinding(extent);
    for (const PeriodRun& run : runs) {
        if (run.name.empty()) continue;
        for (std::size_t i = 0; i < run.contestants.size(); ++i) addRow(finding, run, i);
        finding.charts.push_back(chartOf(run));
    }
    addRefusals(finding, runs);
    return finding;
}

namespace {

void addTo(Finding& finding, int resolution, const StartList& engines, const std::vector<Placing>& placings) {
    for (std::size_t i = 0; i < placings.size(); ++i) {
        const Placing& placing = placings[i];
        TableCell seconds;
        if (placing.timed()) {
            seconds = placing.medianS;
            finding.charts[0].series[i].points.push_back({double(resolution), placing.medianS, {}});
        }
        finding.table.rows.push_back({engines.contestants[i].engine, double(resolution), seconds,
                                      double(placing.runs), placing.error.areaPct, placing.error.cellMeanPct,
                                      placing.refusal});
    }
}

// Four times the cells: from one resolution to its double.
void addGrowth(Finding& finding, int finest) {
    for (const ChartSeries& series : finding.charts[0].series) {
        if (series.points.size() < 2) continue;
        const ChartPoint &first = series.points.front(), &last = series.points.back();
        const double cells = (last.x * last.x) / (first.x * first.x);
        finding.comparisons[0].rows.push_back(
            {series.name, fmt::format("{:.4f}", first.y),
             fmt::format("{:.3f}{}", last.y, describeResolutionIfCoarser(finest, last.x)),
             fmt::format("{:.1f} for {:.0f}", last.y / first.y, cells)});
    }
}

// One of each engine, without points yet.
void addEmptySeries(Chart& chart, const StartList& engines) {
    for (const Contestant& engine : engines.contestants)
        chart.series.push_back({.name = engine.name, .colourOf = engine.engine});
}

Finding emptyScalingFinding(const BenchSite& site, const Extent& extent, const StartList& engines) {
    Finding finding;
    finding.key = "time_by_resolution";
    finding.title = "Time by resolution";
    finding.text = fmt::format(
        "{:g} m in the middle of the city, divided into increasing numbers of cells, over the hour from noon "
        "on {} at every minute. Medians of {} runs in turn, after the check against rays. The paper found "
        "both accrual maps linear in the number of cells.",
        site.sideM, formatText(site.date), extent.runs);
    finding.table.columns = {"engine",         "cells_a_side",        "time_s", "runs",
                             "area_error_pct", "cell_error_mean_pct", "refusal"};
    finding.comparisons[0].header = {"engine", fmt::format("{}, s", extent.resolutions.front()),
                                     fmt::format("{}, s", extent.resolutions.back()),
                                     "times as long, for cells"};
    finding.charts = {{"Time for one hour of sun", {"cells per side", true}, {"time, s", true}, {}}};
    addEmptySeries(finding.charts[0], engines);
    return finding;
}

}  // namespace

Finding benchTimeByResolution(const std::vector<ResolutionRun>& runs, const BenchSite& site,
                              const Extent& extent, const StartList& engines) {
    Finding finding = emptyScalingFinding(site, extent, engines);
    for (const ResolutionRun& run : runs) addTo(finding, run.cellsASide, engines, run.placings);
    addGrowth(finding, extent.resolutions.back());
    return finding;
}

namespace {

constexpr double mebibyte = 1024 * 1024;

/// Table 2: MB at 2048 x 2048, and bytes per cell.
struct PaperMemory {
    const char* name;
    double mebibytesAt2048;
};
const std::map<std::string, PaperMemory, std::less<>>& paperMemory() {
    static const std::map<std::string, PaperMemory, std::less<>> table{{"shadow-map-gl", {"Shadow map", 16}},
                                                                       {"sam", {"Shadow accrual map", 960}},
                                                                       {"ray", {"Ray tracing", 16}},
                                                                       {"iam", {"Inverse accrual map", 224}}};
    return table;
}

void addTo(Finding& finding, std::size_t place, const Contestant& engine, int resolution,
           const std::optional<std::uint64_t>& bytes) {
    if (!bytes) return;
    finding.table.rows.push_back({engine.engine, double(resolution), double(*bytes) / mebibyte});
    finding.charts[0].series[place].points.push_back({double(resolution), double(*bytes) / mebibyte, {}});
}

std::string paperBytesACell(const std::string& engine) {
    const auto paper = paperMemory().find(engine);
    if (paper == paperMemory().end()) return {};
    return fmt::format("{:.0f}", paper->second.mebibytesAt2048 * mebibyte / (2048.0 * 2048.0));
}

// Bytes per cell between the smallest and the largest resolution, so that constant memory cancels.
void addComparison(Finding& finding, int finest) {
    for (const ChartSeries& series : finding.charts[0].series) {
        if (series.points.size() < 2) continue;
        const ChartPoint &first = series.points.front(), &last = series.points.back();
        const double bytes = mebibyte * (last.y - first.y) / (last.x * last.x - first.x * first.x);
        finding.comparisons[0].rows.push_back(
            {series.name, fmt::format("{:.0f}{}", last.y, describeResolutionIfCoarser(finest, last.x)),
             fmt::format("{:.0f}", bytes), paperBytesACell(series.colourOf)});
    }
}

void addPaper(Finding& finding, const Extent& extent) {
    for (const auto& [key, paper] : paperMemory()) {
        ChartSeries series{
            .name = std::string(paper.name) + ", paper", .colourOf = key, .marked = false, .estimated = true};
        for (const int resolution : {extent.resolutions.front(), extent.resolutions.back()})
            series.points.push_back({double(resolution),
                                     paper.mebibytesAt2048 * resolution * resolution / (2048.0 * 2048.0),
                                     {}});
        finding.charts[0].series.push_back(std::move(series));
    }
}

Finding emptyScalingFinding(const StartList& engines, const Extent& extent) {
    Finding finding;
    finding.key = "memory_by_resolution";
    finding.title = "Memory by resolution";
    finding.text =
        "Peak memory of the process while an engine computed the hour of the previous page, beyond city and "
        "receivers: includes the field, and the ray scene of the buildings in reach if there is one. Bytes "
        "per cell are computed between the smallest and the largest resolution, so that constant memory "
        "cancels. The paper counts the maps only.";
    finding.table.columns = {"engine", "cells_a_side", "peak_mib"};
    finding.comparisons[0].header = {"engine", fmt::format("MiB at {}", extent.resolutions.back()),
                                     "bytes per cell", "paper"};
    finding.charts = {{"Memory of an engine", {"cells per side", true}, {"peak, MiB", true}, {}}};
    addEmptySeries(finding.charts[0], engines);
    return finding;
}

}  // namespace

Finding benchMemoryByResolution(const std::vector<ResolutionRun>& runs, const Extent& extent,
                                const StartList& engines) {
    Finding finding = emptyScalingFinding(engines, extent);
    for (const ResolutionRun& run : runs)
        for (std::size_t i = 0; i < run.placings.size(); ++i)
            if (const Placing& placing = run.placings[i]; placing.timed())
                addTo(finding, i, engines.contestants[i], run.cellsASide, placing.peakBytes);
    addComparison(finding, extent.resolutions.back());
    addPaper(finding, extent);
    return finding;
}

}  // namespace noonmark::bench
