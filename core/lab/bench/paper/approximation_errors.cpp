#include "core/lab/bench/paper/paper_bench.h"

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <random>

#include "core/lab/bench/contests/contest.h"
#include "core/lab/bench/contests/moments.h"
#include "core/lab/graph/interval_engine.h"

namespace noonmark::bench {

namespace {

/// A column of the paper's Table 1.
struct PaperColumn {
    int minutes;
    double mean;
    double deviation;
    double median;
};
constexpr std::array<PaperColumn, 6> paperTable{{{5, 0.99999, 1.31e-6, 1},
                                                 {10, 0.99999, 0.93e-6, 1},
                                                 {30, 0.99999, 1.90e-6, 1},
                                                 {60, 0.99999, 4.92e-6, 0.99999},
                                                 {120, 0.99997, 25.5e-6, 0.99998},
                                                 {240, 0.99952, 415e-6, 0.99965}}};

/// The sun at any time of a year.
class SunOfYear {
public:
    static Result<SunOfYear> of(const BenchSite& site) {
        const Instant from = std::chrono::sys_days(site.date.year() / std::chrono::January / 1);
        auto ephemeris =
            Ephemeris::over({.place = site.city.frame.origin()}, from, from + std::chrono::days(367));
        if (!ephemeris) return tl::make_unexpected(ephemeris.error());
        return SunOfYear(from, std::move(*ephemeris));
    }

    [[nodiscard]] SolarPosition at(int minute) const {
        return ephemeris_.at(from_ + std::chrono::minutes(minute));
    }
    [[nodiscard]] glm::dvec3 direction(int minute) const {
        const SolarPosition position = at(minute);
        return toDirection(position.azimuth, position.altitude);
    }
    /// Whether the sun is up at the first and the last minute. In a polar summer's night it may be down in
    /// between, which does not matter.
    [[nodiscard]] bool upThrough(int minute, int minutes) const {
        return at(minute).altitude.value > 0 && at(minute + minutes).altitude.value > 0;
    }

private:
    SunOfYear(Instant from, Ephemeris ephemeris) : from_(from), ephemeris_(std::move(ephemeris)) {}
    Instant from_;
    Ephemeris ephemeris_;
};

struct Straightness {
    Moments cosine;
    Moments angleDeg;
};

double angleDegBetween(glm::dvec3 a, glm::dvec3 b) {
    return Radians{std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b))}.degrees().value;
}

Straightness straightness(const SunOfYear& sun, int minutes, const BenchSite& site, int times) {
    constexpr int minutesOfYear = 365 * 24 * 60, maxTries = 100;
    std::mt19937 random(site.seed);
    std::vector<double> cosines, angles;
    for (int found = 0, tries = 0; found < times && tries < maxTries * times; ++tries) {
        const int start = int(random() % minutesOfYear);
        if (!sun.upThrough(start, minutes)) continue;
        ++found;
        const SunInterval straight{sun.direction(start), sun.direction(start + minutes), minutes + 1};
        for (int minute = 0; minute <= minutes; ++minute) {
            const glm::dvec3 is = sun.direction(start + minute), taken = straight.at(minute);
            cosines.push_back(glm::dot(is, taken));
            angles.push_back(angleDegBetween(is, taken));
        }
    }
    return {computeMoments(std::move(cosines)), computeMoments(std::move(angles))};
}

void addTo(Finding& finding, const PaperColumn& paper, const Straightness& ours) {
    finding.table.rows.push_back({double(paper.minutes), ours.cosine.mean, ours.cosine.deviation,
                                  ours.cosine.median, ours.angleDeg.mean, ours.angleDeg.maximum, paper.mean,
                                  paper.deviation, paper.median});
    finding.comparisons[0].rows.push_back(
        {fmt::format("{} min", paper.minutes), fmt::format("{:.5f}", ours.cosine.mean),
         fmt::format("{:.5f}", paper.mean), fmt::format("{:.3g}", ours.cosine.deviation * 1e6),
         fmt::format("{:.3g}", paper.deviation * 1e6), fmt::format("{:.5f}", ours.cosine.median),
         fmt::format("{:.5f}", paper.median)});
    const double x = paper.minutes;
    finding.charts[0].series[0].points.push_back({x, ours.angleDeg.mean, {}});
    finding.charts[0].series[1].points.push_back({x, ours.angleDeg.maximum, {}});
    finding.charts[1].series[0].points.push_back({x, ours.cosine.deviation, {}});
    finding.charts[1].series[1].points.push_back({x, paper.deviation, {}});
}

Finding emptyLinearity(const Extent& extent) {
    Finding finding;
    finding.key = "sun_linearity";
    finding.title = "How straight the sun's path is";
    finding.text = fmt::format(
        "Between the ends of an interval the accrual maps move the sun along a great circle in equal angles. "
        "This experiment compares that direction with the sun's own (ERFA, without refraction) at every "
        "minute of intervals that begin at {} random times of the year. The paper's deviations for 5 and 10 "
        "minutes are rounding errors of single precision; ours are in double.",
        extent.sunTimes);
    finding.table.columns = {"interval_min",  "cosine_mean", "cosine_sd", "cosine_median", "angle_mean_deg",
                             "angle_max_deg", "paper_mean",  "paper_sd",  "paper_median"};
    finding.comparisons[0].header = {"interval", "mean cosine", "paper", "sd, 1e-6",
                                     "paper",    "median",      "paper"};
    const ChartAxis interval{"interval, min", true};
    finding.charts = {
        {"Angle between the sun and the straight path",
         interval,
         {"angle, deg", true},
         {{"mean", "ours"}, {"largest", "most"}}},
        {"Spread of its cosine", interval, {"standard deviation", true}, {{"ours", "ours"}, {"paper", ""}}}};
    finding.charts[1].series[1].estimated = true;
    return finding;
}

}  // namespace

Result<Finding> benchSunLinearity(const BenchSite& site, const Extent& extent, const Work& work) {
    const auto sun = SunOfYear::of(site);
    if (!sun) return tl::make_unexpected(sun.error());
    Finding finding = emptyLinearity(extent);
    Pieces pieces(work, "the sun's path", paperTable.size());
    for (const PaperColumn& paper : paperTable) {
        pieces.next();
        if (work.stopped()) return cancelled();
        addTo(finding, paper, straightness(*sun, paper.minutes, site, extent.sunTimes));
    }
    return finding;
}

namespace {

constexpr std::size_t levelsOfPaper = 3;

/// Errors of all levels in one hour; the first element is for one level.
struct LevelErrors {
    int position = 0;
    CivilDate date;
    double altitudeDeg = 0;  ///< lowest altitude of the sun in the hour
    std::vector<FieldError> errors;
};

double lowestDeg(const SunSteps& sun) {
    float lowest = 90;
    for (const SunStep& step : sun.steps) lowest = std::min(lowest, step.altitudeDeg);
    return double(lowest);
}

Result<LevelErrors> errorsIn(const Scene& scene, const std::vector<Contestant>& levels, const Work& work) {
    const auto truth = computeTruth(scene, scene.receivers, work);
    if (!truth) return tl::make_unexpected(truth.error());
    LevelErrors errors;
    errors.altitudeDeg = lowestDeg(scene.sun);
    NoProgress silent;
    for (const Contestant& level : levels) {
        const auto field =
            level.accumulator->accumulate(scene.city, scene.receivers, scene.sun, silent, work.stop);
        if (!field) return tl::make_unexpected(field.error());
        errors.errors.push_back(errorOf(*field, truth->field, scene.receivers));
    }
    return errors;
}

/// Random hours and places, one after the other.
class RandomHours {
public:
    RandomHours(const BenchSite& site, const Extent& extent, const Work& work)
        : site_(site), work_(work), random_(site.seed), squares_(pickRandomSquares(site, extent.positions)) {}

    Result<LevelErrors> next(std::size_t hour, const std::vector<Contestant>& levels) {
        const std::size_t position = hour % squares_.size();
        const auto receivers = placeReceiversOnGround(site_.city, squares_[position], {}, work_.stop);
        if (!receivers) return tl::make_unexpected(receivers.error());
        const CivilDate date = pickRandomDays(site_, 365)[random_() % 365];
        const auto day = daylightOf(site_, date);
        if (!day) return tl::make_unexpected(day.error());
        const std::size_t count = std::min<std::size_t>(stepsPerHour, day->steps.size());
        const std::size_t first = random_() % (day->steps.size() - count + 1);
        const SunSteps sun = sliceSteps(*day, first, count);
        return errorsIn({site_.city, *receivers, sun}, levels, work_).map([&](LevelErrors errors) {
            errors.position = int(position) + 1;
            errors.date = date;
            return errors;
        });
    }

private:
    const BenchSite& site_;
    const Work& work_;
    std::mt19937 random_;
    std::vector<Region> squares_;
};

void addHours(Finding& finding, const std::vector<LevelErrors>& hours) {
    for (const LevelErrors& hour : hours)
        for (std::size_t level = 0; level < hour.errors.size(); ++level)
            finding.table.rows.push_back({double(level + 1), double(hour.position), formatText(hour.date),
                                          hour.altitudeDeg, hour.errors[level].areaPct,
                                          hour.errors[level].cellMeanPct, hour.errors[level].cellMaxPct});
}

void addLevels(Finding& finding, const std::vector<LevelErrors>& hours) {
    auto& series = finding.charts[0].series;
    for (std::size_t level = 0; level < hours.front().errors.size(); ++level) {
        std::vector<double> areas;
        for (const LevelErrors& hour : hours) areas.push_back(hour.errors[level].areaPct);
        const Moments area = computeMoments(areas);
        const double x = double(level + 1);
        series[0].points.push_back({x, area.mean, {}});
        series[1].points.push_back({x, area.median, {}});
        series[2].points.push_back({x, area.maximum, {}});
        const bool papers = level + 1 == levelsOfPaper;
        finding.comparisons[0].rows.push_back({fmt::format("{}", level + 1), fmt::format("{:.2f}", area.mean),
                                               papers ? "< 1" : "", fmt::format("{:.2f}", area.median),
                                               papers ? "0.7" : "", fmt::format("{:.2f}", area.maximum),
                                               papers ? "2.6" : ""});
        if (papers)
            finding.summary = {{"iam_area_error_mean_pct", area.mean},
                               {"iam_area_error_max_pct", area.maximum}};
    }
}

// Low suns cast long shadows: the paper's remark on dawn and dusk.
void addAltitudes(Finding& finding, const std::vector<LevelErrors>& hours) {
    ChartSeries& series = finding.charts[1].series[0];
    for (const LevelErrors& hour : hours)
        if (hour.errors.size() >= levelsOfPaper)
            series.points.push_back({hour.altitudeDeg, hour.errors[levelsOfPaper - 1].areaPct, {}});
}

Finding emptyLevelFinding(const Extent& extent) {
    Finding finding;
    finding.key = "level_error";
    finding.title = "Inverse accrual map: error by source level";
    finding.text = fmt::format(
        "{} random hours between sunrise and sunset at {} places; the map with 1 to 6 occluders followed "
        "from each cell, against rays at every minute. Area error is the difference of the shadow areas, of "
        "the receivers' area. On the right: the hours with 3 levels, by the altitude of the sun.",
        extent.hours, extent.positions);
    finding.table.columns = {"levels",
                             "position",
                             "date",
                             "lowest_sun_deg",
                             "area_error_pct",
                             "cell_error_mean_pct",
                             "cell_error_max_pct"};
    finding.comparisons[0].header = {"levels", "mean, %", "paper", "median", "paper", "largest", "paper"};
    const auto paperAt3 = [](double y) {
        return ChartSeries{
            .name = "paper", .colourOf = "paper", .points = {{3, y, {}}}, .joined = false, .estimated = true};
    };
    finding.charts = {
        {"Area error by level",
         {.label = "source levels", .whole = true},
         {"area error, %", false, true},
         {{"mean", "ours"}, {"median", "edge"}, {"largest", "most"}, paperAt3(0.7), paperAt3(2.6)}},
        {"Area error by the sun's altitude, 3 levels",
         {"lowest altitude in the hour, deg", false, true},
         {"area error, %", false, true},
         {{.name = "one hour at one place", .colourOf = "ours", .joined = false}}}};
    return finding;
}

}  // namespace

Result<Finding> benchLevelError(const BenchSite& site, const Extent& extent, const EngineList& engines,
                                const Work& work) {
    Finding finding = emptyLevelFinding(extent);
    const std::vector<Contestant> levels = listVariants(engines, "iam", "levels", {1, 2, 3, 4, 5, 6});
    std::vector<LevelErrors> hours;
    RandomHours randomHours(site, extent, work);
    Pieces pieces(work, "source levels", std::size_t(extent.hours));
    for (int hour = 0; hour < extent.hours && !levels.empty(); ++hour) {
        pieces.next();
        auto errors = randomHours.next(std::size_t(hour), levels);
        if (!errors && isCancelled(errors.error())) return tl::make_unexpected(errors.error());
        if (errors)
            hours.push_back(std::move(*errors));
        else
            finding.remarks.push_back(errors.error().text());
    }
    if (hours.empty()) return finding;
    addHours(finding, hours);
    addLevels(finding, hours);
    addAltitudes(finding, hours);
    return finding;
}

}  // namespace noonmark::bench
