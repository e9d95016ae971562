#include "core/bench/paper/sun_linearity.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <random>

#include "core/bench/contests/moments.h"
#include "core/engines/common/interval_engine.h"

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
                                  ours.cosine.median, ours.angleDeg.mean, ours.angleDeg.most, paper.mean,
                                  paper.deviation, paper.median});
    finding.comparisons[0].rows.push_back(
        {fmt::format("{} min", paper.minutes), fmt::format("{:.5f}", ours.cosine.mean),
         fmt::format("{:.5f}", paper.mean), fmt::format("{:.3g}", ours.cosine.deviation * 1e6),
         fmt::format("{:.3g}", paper.deviation * 1e6), fmt::format("{:.5f}", ours.cosine.median),
         fmt::format("{:.5f}", paper.median)});
    const double x = paper.minutes;
    finding.charts[0].series[0].points.push_back({x, ours.angleDeg.mean, {}});
    finding.charts[0].series[1].points.push_back({x, ours.angleDeg.most, {}});
    finding.charts[1].series[0].points.push_back({x, ours.cosine.deviation, {}});
    finding.charts[1].series[1].points.push_back({x, paper.deviation, {}});
}

Finding emptyFinding(const Extent& extent) {
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
    Finding finding = emptyFinding(extent);
    Pieces pieces(work, "the sun's path", paperTable.size());
    for (const PaperColumn& paper : paperTable) {
        pieces.next();
        if (work.stopped()) return cancelled();
        addTo(finding, paper, straightness(*sun, paper.minutes, site, extent.sunTimes));
    }
    return finding;
}

}  // namespace noonmark::bench
