#include "core/accumulate/graph_accumulator.h"

#include <fmt/format.h>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <map>

#include "core/accumulate/blank_field.h"
#include "core/stopwatch.h"

namespace noonmark {

namespace {

SunSteps directionsOf(const DirectionGraph& graph) {
    SunSteps directions;
    for (const auto& edge : graph.edges)
        for (int step = 0; step < edge.sun.steps; ++step)
            directions.steps.push_back({.direction = glm::vec3(edge.sun.at(step))});
    return directions;
}

/// Runs of the edges that a later path still needs: 4 bytes a receiver and edge, half of what the masks would
/// take.
class LiveMaps {
public:
    explicit LiveMaps(const DirectionGraph& graph) : lastPath_(graph.edges.size(), 0) {
        for (std::size_t path = 0; path < graph.paths.size(); ++path)
            for (const auto& leg : graph.paths[path]) lastPath_[leg.edge] = path;
    }

    [[nodiscard]] bool has(std::uint32_t edge) const { return maps_.contains(edge); }
    [[nodiscard]] std::span<const MaskRuns> of(std::uint32_t edge) const { return maps_.at(edge); }

    void keep(std::uint32_t edge, std::vector<MaskRuns> runs) {
        maps_[edge] = std::move(runs);
        most_ = std::max(most_, maps_.size());
    }

    void dropAfter(std::size_t path) {
        std::erase_if(maps_, [&](const auto& map) { return lastPath_[map.first] <= path; });
    }

    [[nodiscard]] std::size_t most() const { return most_; }

private:
    std::vector<std::size_t> lastPath_;
    std::map<std::uint32_t, std::vector<MaskRuns>> maps_;
    std::size_t most_ = 0;
};

/// Gross and continuous of every receiver, in steps.
class Tally {
public:
    explicit Tally(std::size_t receivers) : gross_(receivers), longest_(receivers) {}

    struct PathLeg {
        std::span<const MaskRuns> runs;
        int steps = 0;
        bool breaksRun = false;
    };

    /// The runs of one edge's masks, its gross shadow counted for every interval that takes it.
    std::vector<MaskRuns> addEdge(std::span<const ShadowMask> masks, const DirectionGraph::Edge& edge) {
        std::vector<MaskRuns> runs(masks.size());
        forReceivers([&](std::size_t i) {
            runs[i] = runsOf(masks[i], edge.sun.steps);
            gross_[i] += std::uint64_t(runs[i].gross) * edge.weight;
        });
        return runs;
    }

    void addPath(const std::vector<PathLeg>& legs) {
        forReceivers([&](std::size_t i) { longest_[i] = std::max(longest_[i], longestAlong(legs, i)); });
    }

    [[nodiscard]] double gross(std::size_t i) const { return double(gross_[i]); }
    [[nodiscard]] double longest(std::size_t i) const { return double(longest_[i]); }

private:
    template <class Body>
    void forReceivers(const Body& body) {
        tbb::parallel_for(tbb::blocked_range<std::size_t>(0, gross_.size(), 8192), [&](const auto& range) {
            for (std::size_t i = range.begin(); i < range.end(); ++i) body(i);
        });
    }

    // Runs that cross from one leg to the next are the suffix of one and the prefix of the other.
    static std::uint32_t longestAlong(const std::vector<PathLeg>& legs, std::size_t i) {
        std::uint32_t longest = 0;
        std::uint32_t run = 0;
        for (const PathLeg& leg : legs) {
            const MaskRuns runs = leg.runs[i];
            if (leg.breaksRun) run = 0;
            longest = std::max({longest, std::uint32_t(runs.longest), run + runs.prefix});
            run = runs.suffix == leg.steps ? run + runs.suffix : runs.suffix;
        }
        return longest;
    }

    std::vector<std::uint64_t> gross_;
    std::vector<std::uint32_t> longest_;
};

void fill(ShadowField& field, const Receivers& receivers, const Tally& tally) {
    for (std::size_t i = 0; i < receivers.cells.size(); ++i) {
        field.grossMin[receivers.cells[i]] = float(tally.gross(i) * field.stepMinutes / field.days);
        field.continuousMin[receivers.cells[i]] = float(tally.longest(i) * field.stepMinutes);
    }
}

/// One run over the graph.
class GraphRun {
public:
    GraphRun(const DirectionGraph& graph, IntervalScene& scene, std::size_t receivers, Progress& progress,
             std::stop_token stop)
        : graph_(graph),
          scene_(scene),
          progress_(progress),
          stop_(std::move(stop)),
          maps_(graph),
          tally_(receivers),
          masks_(receivers) {}

    Result<void> run() {
        for (std::size_t path = 0; path < graph_.paths.size(); ++path) {
            if (const auto done = addPath(graph_.paths[path]); !done) return done;
            maps_.dropAfter(path);
            if (stop_.stop_requested()) return cancelled();
        }
        return {};
    }

    [[nodiscard]] const Tally& tally() const { return tally_; }
    [[nodiscard]] std::size_t mostLiveMaps() const { return maps_.most(); }

private:
    Result<void> addPath(const DirectionGraph::Path& path) {
        std::vector<Tally::PathLeg> legs;
        for (const auto& leg : path) {
            if (!maps_.has(leg.edge))
                if (const auto done = shade(leg.edge); !done) return done;
            legs.push_back({maps_.of(leg.edge), graph_.edges[leg.edge].sun.steps, leg.breaksRun});
        }
        tally_.addPath(legs);
        return {};
    }

    Result<void> shade(std::uint32_t edge) {
        progress_.report(double(shaded_++) / double(graph_.edges.size()), "shading intervals");
        if (const auto done = scene_.shade(graph_.edges[edge].sun, masks_, stop_); !done) return done;
        maps_.keep(edge, tally_.addEdge(masks_, graph_.edges[edge]));
        return {};
    }

    const DirectionGraph& graph_;
    IntervalScene& scene_;
    Progress& progress_;
    std::stop_token stop_;
    LiveMaps maps_;
    Tally tally_;
    std::vector<ShadowMask> masks_;  // of the edge at work
    std::size_t shaded_ = 0;
};

// A step of less than a minute makes the intervals shorter: a mask holds 64 steps.
DirectionGraphSettings fitting(DirectionGraphSettings settings, double stepMinutes) {
    settings.intervalMinutes = std::min(settings.intervalMinutes, maxMaskSteps * stepMinutes);
    return settings;
}

}  // namespace

GraphAccumulator::GraphAccumulator(std::shared_ptr<const IntervalEngine> engine,
                                   DirectionGraphSettings settings)
    : engine_(std::move(engine)), settings_(settings) {}

Result<ShadowField> GraphAccumulator::accumulate(const City& city, const Receivers& receivers,
                                                 const SunSteps& sun, Progress& progress,
                                                 std::stop_token stop) const {
    const auto graph = directionGraph(sun, fitting(settings_, sun.stepMinutes));
    if (!graph) return tl::make_unexpected(graph.error());
    const Stopwatch watch;
    auto scene = engine_->prepare(city, receivers, directionsOf(*graph), stop);
    if (!scene) return tl::make_unexpected(scene.error());
    const double build = watch.seconds();
    GraphRun run(*graph, **scene, receivers.cells.size(), progress, stop);
    if (const auto done = run.run(); !done) return tl::make_unexpected(done.error());

    ShadowField field = blankField(receivers, sun);
    const Cost untouched = field.cost;
    fill(field, receivers, run.tally());
    field.cost = (*scene)->cost();
    field.cost.skipped.insert(untouched.skipped.begin(), untouched.skipped.end());
    field.cost.seconds["build"] += build;
    field.cost.skipped["intervals that share an edge of the direction graph"] =
        graph->intervals - graph->edges.size();
    field.engine =
        fmt::format("{}; direction graph with {} edges for {} intervals, {} maps alive at most",
                    engine_->describe(), graph->edges.size(), graph->intervals, run.mostLiveMaps());
    return field;
}

}  // namespace noonmark
