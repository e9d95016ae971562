#include "core/bench/paper/graph_bound.h"

#include <fmt/format.h>

#include <array>
#include <glm/geometric.hpp>
#include <map>
#include <random>
#include <set>

#include "core/bench/contests/moments.h"
#include "core/bench/paper/graph_lookup.h"

namespace noonmark::bench {

namespace {

constexpr std::array<double, 5> boundsDeg{1, 2, 5, 10, 20};
constexpr double paperBoundDeg = 5;
constexpr int hourSteps = 60;

/// Results of one bound over the year.
struct BoundFigures {
    double boundDeg = 0;
    std::size_t edges = 0;
    std::size_t edgesOfPlainBins = 0;
    std::uint64_t intervals = 0;
    Moments toBin;   ///< cosine of a direction and the mean of its bin
    Moments toEdge;  ///< cosine of a direction and the direction of its edge
};

Moments similarityToBin(const SunSteps& year, const DirectionBins& bins,
                        const std::vector<std::size_t>& times) {
    const auto binOf = [&](const SunStep& step) { return bins.of(glm::dvec3(step.direction)); };
    std::map<std::uint32_t, glm::dvec3> sums;
    for (const SunStep& step : year.steps) sums[binOf(step)] += glm::dvec3(step.direction);
    std::vector<double> cosines;
    for (const std::size_t time : times) {
        const SunStep& step = year.steps[time % year.steps.size()];
        cosines.push_back(glm::dot(glm::dvec3(step.direction), glm::normalize(sums.at(binOf(step)))));
    }
    return computeMoments(std::move(cosines));
}

// Picks day and hour of random steps; skips the remainder of a day that has no edge of a whole hour.
Moments similarityToEdge(const SunSteps& year, const DirectionGraph& graph,
                         const std::vector<std::size_t>& times) {
    const GraphLookup edges(graph);
    std::vector<double> cosines;
    for (const std::size_t time : times) {
        const SunDay& day = year.days[time % year.days.size()];
        if (day.count < hourSteps) continue;
        const std::size_t hour = (time / year.days.size()) % (day.count / hourSteps);
        const std::size_t first = day.first + hour * hourSteps, step = time % hourSteps;
        const auto* edge = edges.find(year.steps[first], year.steps[first + hourSteps - 1], hourSteps);
        if (edge == nullptr) continue;
        cosines.push_back(glm::dot(glm::dvec3(year.steps[first + step].direction), edge->sun.at(int(step))));
    }
    return computeMoments(std::move(cosines));
}

/// Number of edges if bins are `boundDeg` wide in azimuth and in altitude, one reading of the paper's quads.
std::size_t edgesOfPlainBins(const SunSteps& year, double boundDeg) {
    const auto binOfPlain = [&](const SunStep& step) {
        return std::pair(int(double(step.azimuthDeg) / boundDeg), int(double(step.altitudeDeg) / boundDeg));
    };
    std::set<std::pair<std::pair<int, int>, std::pair<int, int>>> edges;
    for (const SunDay& day : year.days)
        for (std::uint32_t first = 0; first + hourSteps <= day.count; first += hourSteps)
            edges.emplace(binOfPlain(year.steps[day.first + first]),
                          binOfPlain(year.steps[day.first + first + hourSteps - 1]));
    return edges.size();
}

Result<BoundFigures> figuresAt(double boundDeg, const SunSteps& year, const std::vector<std::size_t>& times) {
    const auto graph = buildDirectionGraph(year, {.boundDeg = boundDeg});
    if (!graph) return tl::make_unexpected(graph.error());
    return BoundFigures{boundDeg,
                        graph->edges.size(),
                        edgesOfPlainBins(year, boundDeg),
                        graph->intervals,
                        similarityToBin(year, graph->bins, times),
                        similarityToEdge(year, *graph, times)};
}

void addPaperColumns(Finding& finding, const BoundFigures& figures) {
    const auto row = [&](const char* what, std::string ours, const char* paper) {
        finding.comparisons[0].rows.push_back({what, std::move(ours), paper});
    };
    row("edges of a year", fmt::format("{}", figures.edges), "299");
    row("with bins of azimuth and altitude", fmt::format("{}", figures.edgesOfPlainBins), "");
    row("hourly intervals", fmt::format("{}", figures.intervals), "2190");
    row("similarity to the bin, mean", fmt::format("{:.5f}", figures.toBin.mean), "0.9996");
    row("its standard deviation", fmt::format("{:.1e}", figures.toBin.deviation), "3e-4");
    row("similarity to the edge, mean", fmt::format("{:.5f}", figures.toEdge.mean), "");
    row("its standard deviation", fmt::format("{:.1e}", figures.toEdge.deviation), "");
    finding.summary = {{"graph_edges", double(figures.edges)},
                       {"graph_intervals", double(figures.intervals)}};
}

void addTo(Finding& finding, const BoundFigures& figures) {
    finding.table.rows.push_back({figures.boundDeg, double(figures.edges), double(figures.intervals),
                                  figures.toBin.mean, figures.toBin.deviation, figures.toBin.median,
                                  figures.toEdge.mean, figures.toEdge.deviation, figures.toEdge.median});
    const double x = figures.boundDeg;
    finding.charts[0].series[0].points.push_back({x, double(figures.edges), {}});
    finding.charts[1].series[0].points.push_back({x, 1 - figures.toBin.mean, {}});
    finding.charts[1].series[1].points.push_back({x, 1 - figures.toEdge.mean, {}});
    if (x == paperBoundDeg) addPaperColumns(finding, figures);
}

ChartSeries paperPoint(double y) {
    return {.name = "paper", .colourOf = "paper", .points = {{paperBoundDeg, y, {}}}, .estimated = true};
}

Finding emptyFinding(const Extent& extent) {
    Finding finding;
    finding.key = "graph_bound";
    finding.title = "The direction graph: number of intervals and similarity";
    finding.text = fmt::format(
        "A year of 6 h days from 9:00 in intervals of 60 minutes; directions in bins of at most the bound. "
        "Similarity is the cosine between the sun at {} random times and the direction that replaces it: the "
        "mean of its bin, and the direction that the edge of its interval uses, which is closer, since an "
        "edge runs between the means of its own ends.",
        extent.sunTimes);
    finding.table.columns = {"bound_deg",        "edges",          "intervals",
                             "bin_cosine_mean",  "bin_cosine_sd",  "bin_cosine_median",
                             "edge_cosine_mean", "edge_cosine_sd", "edge_cosine_median"};
    finding.comparisons[0].header = {"at 5 deg", "ours", "paper"};
    const ChartAxis bound{"bound of a bin, deg", true};
    finding.charts = {{"Edges of a year", bound, {"edges", true}, {{"ours", "ours"}, paperPoint(299)}},
                      {"Difference between a direction and its replacement",
                       bound,
                       {"1 - mean cosine", true},
                       {{"mean of its bin", "ours"}, {"its edge", "edge"}, paperPoint(1 - 0.9996)}}};
    return finding;
}

}  // namespace

Result<Finding> benchGraphBound(const BenchSite& site, const Extent& extent, const Work& work) {
    const auto year = computeYearSun(site);
    if (!year) return tl::make_unexpected(year.error());
    std::mt19937 random(site.seed);
    std::vector<std::size_t> times(std::size_t(extent.sunTimes));
    for (std::size_t& time : times) time = random();
    Finding finding = emptyFinding(extent);
    Pieces pieces(work, "the direction graph", boundsDeg.size());
    for (const double boundDeg : boundsDeg) {
        pieces.next();
        if (work.stopped()) return cancelled();
        const auto figures = figuresAt(boundDeg, *year, times);
        if (!figures) return tl::make_unexpected(figures.error());
        addTo(finding, *figures);
    }
    return finding;
}

}  // namespace noonmark::bench
