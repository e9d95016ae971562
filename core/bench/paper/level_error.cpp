#include "core/bench/paper/level_error.h"

#include <fmt/format.h>

#include <random>

#include "core/bench/contests/contest.h"
#include "core/bench/contests/moments.h"

namespace noonmark::bench {

namespace {

constexpr int hourSteps = 60;
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
        const std::size_t count = std::min<std::size_t>(hourSteps, day->steps.size());
        const std::size_t first = random_() % (day->steps.size() - count + 1);
        const SunSteps sun = stretchOf(*day, first, count);
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
        series[2].points.push_back({x, area.most, {}});
        const bool papers = level + 1 == levelsOfPaper;
        finding.comparisons[0].rows.push_back({fmt::format("{}", level + 1), fmt::format("{:.2f}", area.mean),
                                               papers ? "< 1" : "", fmt::format("{:.2f}", area.median),
                                               papers ? "0.7" : "", fmt::format("{:.2f}", area.most),
                                               papers ? "2.6" : ""});
        if (papers)
            finding.summary = {{"iam_area_error_mean_pct", area.mean}, {"iam_area_error_max_pct", area.most}};
    }
}

// Low suns cast long shadows: the paper's remark on dawn and dusk.
void addAltitudes(Finding& finding, const std::vector<LevelErrors>& hours) {
    ChartSeries& series = finding.charts[1].series[0];
    for (const LevelErrors& hour : hours)
        if (hour.errors.size() >= levelsOfPaper)
            series.points.push_back({hour.altitudeDeg, hour.errors[levelsOfPaper - 1].areaPct, {}});
}

Finding emptyFinding(const Extent& extent) {
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
    Finding finding = emptyFinding(extent);
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
