#include "core/lab/bench/paper/paper_bench.h"

#include <fmt/format.h>
#include <array>
#include <bit>
#include <glm/geometric.hpp>
#include <map>
#include <random>
#include <set>
#include <utility>

#include "core/lab/bench/contests/moments.h"
#include "core/lab/bench/contests/ray_masks.h"
#include "core/lab/graph/direction_graph.h"

namespace noonmark::bench {

namespace {

/// Finds the edge of a merged direction graph for an interval.
class GraphLookup {
public:
    /// `graph` must outlive this object.
    explicit GraphLookup(const DirectionGraph& graph) : bins_(graph.bins), stepMinutes_(graph.stepMinutes) {
        for (const auto& edge : graph.edges) edges_[{{edge.fromBin, edge.toBin}, edge.sun.steps}] = &edge;
    }

    /// The edge of the interval of `steps` steps from `first` to `last`; null if the graph's period has no
    /// such interval.
    [[nodiscard]] const DirectionGraph::Edge* find(const SunStep& first, const SunStep& last,
                                                   int steps) const {
        const std::uint32_t from = bins_.of(glm::dvec3(first.direction)),
                            to = bins_.of(glm::dvec3(last.direction), stepMinutes_);
        const auto found = edges_.find({{from, to}, steps});
        return found == edges_.end() ? nullptr : found->second;
    }

private:
    using Key = std::pair<std::pair<std::uint32_t, std::uint32_t>, int>;

    DirectionBins bins_;
    double stepMinutes_;
    std::map<Key, const DirectionGraph::Edge*> edges_;
};

constexpr std::array<double, 5> boundsDeg{1, 2, 5, 10, 20};
constexpr double paperBoundDeg = 5;

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
        if (day.count < stepsPerHour) continue;
        const std::size_t hour = (time / year.days.size()) % (day.count / stepsPerHour);
        const std::size_t first = day.first + hour * stepsPerHour, step = time % stepsPerHour;
        const auto* edge = edges.find(year.steps[first], year.steps[first + stepsPerHour - 1], stepsPerHour);
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
        for (std::uint32_t first = 0; first + stepsPerHour <= day.count; first += stepsPerHour)
            edges.emplace(binOfPlain(year.steps[day.first + first]),
                          binOfPlain(year.steps[day.first + first + stepsPerHour - 1]));
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

Finding emptyGraphFinding(const Extent& extent) {
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
    Finding finding = emptyGraphFinding(extent);
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

namespace {

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
        if (day.count < stepsPerHour) return {};
        const std::size_t hour = draw % (day.count / stepsPerHour), first = day.first + hour * stepsPerHour;
        const auto* edge =
            edges_.find(year_.steps[first], year_.steps[first + stepsPerHour - 1], stepsPerHour);
        if (edge == nullptr) return {};
        std::vector<glm::dvec3> is, taken;
        for (int step = 0; step < stepsPerHour; ++step) {
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
        const double toPct = 100.0 / (double(is.size()) * stepsPerHour);
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
    row("area error, largest", areas.maximum, "");
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
    double maximum = 0;
    for (const Hour& hour : hours) {
        finding.table.rows.push_back({double(hour.position), formatText(hour.date), hour.begin, hour.truePct,
                                      hour.graphPct, std::abs(hour.graphPct - hour.truePct),
                                      hour.mistaggedPct});
        points.points.push_back({hour.truePct, hour.graphPct, {}});
        errors.points.push_back({hour.mistaggedPct, std::abs(hour.graphPct - hour.truePct), {}});
        maximum = std::max({maximum, hour.truePct, hour.graphPct});
    }
    const ChartSeries same{.name = "equal", .points = {{0, 0, {}}, {maximum, maximum, {}}}, .marked = false};
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
