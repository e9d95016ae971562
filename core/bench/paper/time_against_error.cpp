#include "core/bench/paper/time_against_error.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

namespace noonmark::bench {

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

Finding emptyFinding(const Extent& extent) {
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
    Finding finding = emptyFinding(extent);
    for (const PeriodRun& run : runs) {
        if (run.name.empty()) continue;
        for (std::size_t i = 0; i < run.contestants.size(); ++i) addRow(finding, run, i);
        finding.charts.push_back(chartOf(run));
    }
    addRefusals(finding, runs);
    return finding;
}

}  // namespace noonmark::bench
