#include "core/bench/paper/graph_error.h"

#include <fmt/format.h>

#include <bit>
#include <random>

#include "core/bench/contests/moments.h"
#include "core/bench/contests/ray_masks.h"
#include "core/bench/paper/graph_lookup.h"

namespace noonmark::bench {

namespace {

constexpr int hourSteps = 60;

/// One random hour at one place.
struct Hour {
    int position = 0;
    CivilDate date;
    std::string begin;        ///< "10:00"
    double truePct = 0;       ///< shadow area with the sun's own directions, of the receivers' area
    double graphPct = 0;      ///< shadow area with the edge's directions, of the receivers' area
    double mistaggedPct = 0;  ///< share of cells and steps with the wrong answer
};

/// The hours of a year and their edges.
class YearOfHours {
public:
    YearOfHours(const SunSteps& year, const DirectionGraph& graph) : year_(year), edges_(graph) {}

    /// Compares one random hour; nothing if the sun is not up for the whole hour.
    std::optional<Hour> compare(const RayMasks& rays, std::mt19937& random) const {
        const SunDay& day = year_.days[random() % year_.days.size()];
        const std::size_t draw = random();
        if (day.count < hourSteps) return {};
        const std::size_t hour = draw % (day.count / hourSteps), first = day.first + hour * hourSteps;
        const auto* edge = edges_.find(year_.steps[first], year_.steps[first + hourSteps - 1], hourSteps);
        if (edge == nullptr) return {};
        std::vector<glm::dvec3> is, taken;
        for (int step = 0; step < hourSteps; ++step) {
            is.emplace_back(year_.steps[first + std::size_t(step)].direction);
            taken.push_back(edge->sun.at(step));
        }
        return difference(rays.of(is), rays.of(taken), day.date,
                          formatText(std::chrono::minutes((9 + int(hour)) * 60)));
    }

private:
    static Hour difference(const std::vector<ShadowMask>& is, const std::vector<ShadowMask>& taken,
                           CivilDate date, std::string begin) {
        std::size_t inShadow = 0, taggedShadow = 0, mistagged = 0;
        for (std::size_t i = 0; i < is.size(); ++i) {
            inShadow += std::size_t(std::popcount(is[i]));
            taggedShadow += std::size_t(std::popcount(taken[i]));
            mistagged += std::size_t(std::popcount(is[i] ^ taken[i]));
        }
        const double toPct = 100.0 / (double(is.size()) * hourSteps);
        return {0,
                date,
                std::move(begin),
                toPct * double(inShadow),
                toPct * double(taggedShadow),
                toPct * double(mistagged)};
    }

    const SunSteps& year_;
    GraphLookup edges_;
};

Result<std::vector<Hour>> comparedHours(const BenchSite& site, const Extent& extent, const Work& work,
                                        const YearOfHours& year) {
    const auto scene = RayScene::over(site.city, work.stop);
    if (!scene) return tl::make_unexpected(scene.error());
    std::mt19937 random(site.seed);
    std::vector<Hour> hours;
    const std::vector<Region> squares = pickRandomSquares(site, extent.graphPositions);
    Pieces pieces(work, "the direction graph's shadows", std::size_t(extent.graphHours));
    for (int position = 0; position < extent.graphPositions; ++position) {
        const auto receivers =
            placeReceiversOnGround(site.city, squares[std::size_t(position)], {}, work.stop);
        if (!receivers) return tl::make_unexpected(receivers.error());
        if (receivers->cells.empty()) continue;
        const RayMasks rays(*scene, sampleOf(*receivers, extent.graphReceivers, site.seed));
        for (int k = position; k < extent.graphHours; k += extent.graphPositions) {
            pieces.next();
            if (work.stopped()) return cancelled();
            if (auto hour = year.compare(rays, random)) {
                hour->position = position + 1;
                hours.push_back(std::move(*hour));
            }
        }
    }
    return hours;
}

void addComparison(Finding& finding, const std::vector<Hour>& hours) {
    std::vector<double> area, mistagged;
    for (const Hour& hour : hours) {
        area.push_back(std::abs(hour.graphPct - hour.truePct));
        mistagged.push_back(hour.mistaggedPct);
    }
    const Moments areas = computeMoments(area), tags = computeMoments(mistagged);
    const auto row = [&](const char* what, double ours, const char* paper) {
        finding.comparisons[0].rows.push_back({what, fmt::format("{:.2f} %", ours), paper});
    };
    row("area error, mean", areas.mean, "0.47 %");
    row("area error, median", areas.median, "0.35 %");
    row("area error, sd", areas.deviation, "0.37 %");
    row("area error, largest", areas.most, "");
    row("mistagged, mean", tags.mean, "0.8 %");
    row("mistagged, sd", tags.deviation, "0.5 %");
    finding.summary = {{"graph_area_error_mean_pct", areas.mean}, {"graph_mistagged_pct", tags.mean}};
}

Finding findingOf(const std::vector<Hour>& hours) {
    Finding finding;
    finding.key = "graph_error";
    finding.title = "Shadows through the direction graph";
    finding.text = fmt::format(
        "Rays at every minute of {} random hours at {} places, once towards the sun and once along the edge "
        "by which the graph (bound 5 deg, a year of 6 h days) replaces it. Areas are of the receivers' area, "
        "as in the paper; mistagged is the share of cells and minutes with the wrong answer.",
        hours.size(), hours.empty() ? 0 : hours.back().position);
    finding.table.columns = {
        "position",       "date",         "begin", "shadow_area_pct", "shadow_area_graph_pct",
        "area_error_pct", "mistagged_pct"};
    finding.comparisons[0].header = {"", "ours", "paper"};
    ChartSeries points{.name = "one hour at one place", .colourOf = "ours", .joined = false};
    ChartSeries errors{.name = "area error", .colourOf = "ours", .joined = false};
    double most = 0;
    for (const Hour& hour : hours) {
        finding.table.rows.push_back({double(hour.position), formatText(hour.date), hour.begin, hour.truePct,
                                      hour.graphPct, std::abs(hour.graphPct - hour.truePct),
                                      hour.mistaggedPct});
        points.points.push_back({hour.truePct, hour.graphPct, {}});
        errors.points.push_back({hour.mistaggedPct, std::abs(hour.graphPct - hour.truePct), {}});
        most = std::max({most, hour.truePct, hour.graphPct});
    }
    const ChartSeries same{.name = "equal", .points = {{0, 0, {}}, {most, most, {}}}, .marked = false};
    finding.charts = {
        {"Shadow area", {"with the sun, %", false, true}, {"with the edge, %", false, true}, {points, same}},
        {"Errors of the hours", {"mistagged, %", false, true}, {"area error, %", false, true}, {errors}}};
    addComparison(finding, hours);
    return finding;
}

}  // namespace

Result<Finding> benchGraphError(const BenchSite& site, const Extent& extent, const Work& work) {
    const auto year = computeYearSun(site);
    if (!year) return tl::make_unexpected(year.error());
    const auto graph = buildDirectionGraph(*year, {});
    if (!graph) return tl::make_unexpected(graph.error());
    return comparedHours(site, extent, work, YearOfHours(*year, *graph))
        .map([&](const std::vector<Hour>& hours) { return findingOf(hours); });
}

}  // namespace noonmark::bench
