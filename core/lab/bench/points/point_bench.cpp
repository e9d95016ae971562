#include "core/lab/bench/points/point_bench.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/base/progress.h"
#include "core/city/city_position.h"
#include "core/engines/points/point_horizons.h"
#include "core/lab/bench/contests/moments.h"
#include "core/lab/bench/paper/paper_bench.h"

namespace noonmark::bench {

namespace {

constexpr std::size_t maxPoints = 100'000;

Result<SunSteps> daylightOfYear(const BenchSite& site) {
    const auto year = site.date.year();
    const Box2 box = bounds(site.city);
    return computeSunSteps({.start = year / std::chrono::January / 1,
                            .days = year.is_leap() ? 366 : 365,
                            .window = SolarHours{},
                            .zone = site.zone},
                           placeObserver(site.city, glm::dvec2(box.low + box.high) / 2.0));
}

struct TimedPoints {
    PointMonths minutes;
    double seconds = 0;
};

Result<TimedPoints> timeSweep(const BenchSite& site, const SurfacePoints& points, const SunSteps& sun,
                              bool runs, const Work& work) {
    const Stopwatch watch;
    auto minutes = sweepPoints(site.city, points, sun, work.progress, work.stop, {.runs = runs});
    if (!minutes) return tl::make_unexpected(minutes.error());
    return TimedPoints{*std::move(minutes), watch.seconds()};
}

/// What all methods are measured on.
struct FacadeContest {
    SurfacePoints points, sample;
    SunSteps sun;
    TimedPoints gross, runs, swept, traced;  // the last two: of the sample

    [[nodiscard]] double raySeconds() const {  // of all points; a ray scene is built once
        const auto& seconds = traced.minutes.cost.seconds;
        return seconds.at("build") + seconds.at("trace") * double(points.size()) / double(sample.size());
    }
    [[nodiscard]] std::vector<double> errorsPct() const {
        std::vector<double> errors;
        for (std::size_t i = 0; i < sample.size(); ++i)
            errors.push_back(100 * std::abs(swept.minutes.sunlitOf(i) - traced.minutes.sunlitOf(i)) /
                             swept.minutes.possibleMin);
        return errors;
    }
};

Result<FacadeContest> runFacadeContest(const BenchSite& site, const Extent& extent, const Work& work) {
    std::vector<std::uint32_t> buildings(site.city.buildings.size());
    std::iota(buildings.begin(), buildings.end(), 0U);
    const auto facades = placeOnFacades(site.city, buildings, {}, work.stop);
    if (!facades) return tl::make_unexpected(facades.error());
    auto sun = daylightOfYear(site);
    if (!sun) return tl::make_unexpected(sun.error());
    FacadeContest contest;
    contest.points = thinOut(facades->points, maxPoints);
    contest.sample = thinOut(contest.points, std::max<std::size_t>(10, extent.sampleReceivers / 10));
    contest.sun = *std::move(sun);
    if (contest.points.size() == 0)
        return failure("The city has no facades", site.name, "Choose a city with buildings");
    const auto take = [](Result<TimedPoints> timed, TimedPoints& into) -> Result<void> {
        if (!timed) return tl::make_unexpected(timed.error());
        into = *std::move(timed);
        return {};
    };
    const auto trace = [&]() -> Result<TimedPoints> {
        const Stopwatch watch;
        auto minutes = tracePoints(site.city, contest.sample, contest.sun, work.progress, work.stop);
        if (!minutes) return tl::make_unexpected(minutes.error());
        return TimedPoints{*std::move(minutes), watch.seconds()};
    };
    const auto done =
        take(timeSweep(site, contest.points, contest.sun, false, work), contest.gross)
            .and_then(
                [&] { return take(timeSweep(site, contest.points, contest.sun, true, work), contest.runs); })
            .and_then([&] {
                return take(timeSweep(site, contest.sample, contest.sun, false, work), contest.swept);
            })
            .and_then([&] { return take(trace(), contest.traced); });
    if (!done) return tl::make_unexpected(done.error());
    return contest;
}

void addRow(Finding& finding, const char* method, std::size_t points, double seconds, double raySeconds) {
    finding.table.rows.push_back({std::string(method), double(points), seconds,
                                  1000 * seconds / double(points), raySeconds / seconds});
    finding.comparisons[0].rows.push_back(
        {method, formatThreeDigits(seconds), formatThreeDigits(raySeconds / seconds)});
}

}  // namespace

SurfacePoints thinOut(const SurfacePoints& all, std::size_t count) {
    SurfacePoints some;
    count = std::min(count, all.size());
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t at = (2 * i + 1) * all.size() / (2 * count);
        some.positions.push_back(all.positions[at]);
        some.normals.push_back(all.normals[at]);
    }
    return some;
}

Result<Finding> benchFacadeYear(const BenchSite& site, const Extent& extent, const Work& work) {
    const auto contest = runFacadeContest(site, extent, work);
    if (!contest) return tl::make_unexpected(contest.error());
    const std::size_t points = contest->points.size();
    const double rays = contest->raySeconds();
    const std::vector<double> errors = contest->errorsPct();
    const double mean = std::accumulate(errors.begin(), errors.end(), 0.0) / double(errors.size());
    const double maximum = *std::ranges::max_element(errors);
    Finding finding;
    finding.key = "facade_year";
    finding.title = "A year on facades";
    finding.text = fmt::format(
        "{} points on facades, every minute of the year from sunrise to sunset ({} steps). Rays on {} of "
        "them, their time extrapolated to all; rays from points that face away are left out. The sunlit time "
        "differs by {:.3f} % of the year in the mean and {:.3f} % at most. Each time is of one run, with "
        "building the scene.",
        points, contest->sun.steps.size(), contest->sample.size(), mean, maximum);
    finding.table.columns = {"method", "points", "time_s", "time_per_point_ms", "vs_ray"};
    finding.comparisons[0].header = {"", "time, s", "times as fast as rays"};
    addRow(finding, "sweep", points, contest->gross.seconds, rays);
    addRow(finding, "sweep with unbroken times", points, contest->runs.seconds, rays);
    addRow(finding, "rays", points, rays, rays);
    finding.summary = {{"points_year_s", contest->gross.seconds},
                       {"points_vs_ray", rays / contest->gross.seconds},
                       {"points_with_runs_vs_ray", rays / contest->runs.seconds},
                       {"points_error_mean_pct", mean},
                       {"points_error_max_pct", maximum}};
    return finding;
}

namespace {

std::vector<SummaryFigure> pointSummary() {
    return {{"points_year_s", "100,000 facade points, a year of daylight minutes, gross, s", "<= 60"},
            targetFigure("points_vs_ray", "the same, times as fast as rays", atLeast(200)),
            {"points_with_runs_vs_ray", "the same with unbroken times", ""},
            {"points_error_mean_pct", "error of the sunlit time, mean, % of the year", ""},
            {"points_error_max_pct", "error of the sunlit time, largest, %", ""}};
}

}  // namespace

Result<BenchReport> runPointBench(const BenchSite& site, const Extent& extent, const EngineList&,
                                  Progress& progress, const std::stop_token& stop) {
    if (const auto fits = check(site); !fits) return tl::make_unexpected(fits.error());
    const Work work{progress, stop};
    Experiments experiments(work);
    experiments.add("A year on facades", [&](const Work& its) { return benchFacadeYear(site, extent, its); });
    return std::move(experiments)
        .into({.title = "Points on facades against rays", .reference = "target", .summary = pointSummary()},
              site, extent);
}

}  // namespace noonmark::bench
