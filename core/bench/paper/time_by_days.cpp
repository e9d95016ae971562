#include "core/bench/paper/time_by_days.h"

#include <fmt/format.h>

#include <map>
#include <optional>

#include "core/bench/contests/moments.h"

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

Finding emptyFinding(const Extent& extent) {
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
    Finding finding = emptyFinding(extent);
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

}  // namespace noonmark::bench
