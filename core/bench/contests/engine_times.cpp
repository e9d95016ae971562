#include "core/bench/contests/engine_times.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <map>
#include <set>

#include "core/bench/contests/contest.h"
#include "core/bench/contests/moments.h"

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
            const std::size_t toCome = std::size_t(extent.positions) * days.size() - all.size();
            auto one = meeting(site, *receivers, days[day], costs,
                               std::max(0.0, work.allowance.leftS()) / double(toCome), extent, engines, work);
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

Finding emptyFinding(const Extent& extent) {
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

}  // namespace

Result<Finding> benchEngineTimes(const BenchSite& site, const Extent& extent, const StartList& engines,
                                 const Work& work) {
    const auto all = meetings(site, extent, engines, work);
    if (!all) return tl::make_unexpected(all.error());
    Finding finding = emptyFinding(extent);
    addRows(finding, engines, *all, extent.hoursADay);
    addEngines(finding, engines, *all, extent.hoursADay);
    finding.comparisons.push_back({{"times as fast", "ours", "paper"}, {}});
    addRatio(finding, "iam_vs_ray", ratioOf("ray", "iam", engines, *all), "IAM / rays", "5.3");
    addAccrualRatios(finding, engines, *all);
    return finding;
}

}  // namespace noonmark::bench
