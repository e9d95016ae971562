#include "core/lab/graph/graph_engine.h"

#include <fmt/format.h>
#include <algorithm>
#include <map>

#include "core/base/progress.h"
#include "core/describe/text.h"
#include "core/engines/api/shadow_field.h"
#include "core/engines/common/run_counter.h"

namespace noonmark {

const Fields<DirectionGraphSettings>& graphFields() {
    static const Fields<DirectionGraphSettings> fields{
        field(&DirectionGraphSettings::intervalMinutes,
              {.key = "interval",
               .label = NM_TEXT("Interval"),
               .help = NM_TEXT("How long the sun is taken to move in a straight line"),
               .unit = "min",
               .range = ValueRange{0.1, 120}}),
        field(&DirectionGraphSettings::boundDeg,
              {.key = "bound",
               .label = NM_TEXT("Direction bound"),
               .help = NM_TEXT("Hours whose sun is less than this apart are computed once"),
               .unit = "deg",
               .range = ValueRange{0.1, 20}})};
    return fields;
}

SunSteps collectDirections(const DirectionGraph& graph) {
    SunSteps directions;
    for (const auto& edge : graph.edges)
        for (int step = 0; step < edge.sun.steps; ++step)
            directions.steps.push_back({.direction = glm::vec3(edge.sun.at(step))});
    return directions;
}

DirectionGraphSettings fitToMasks(DirectionGraphSettings settings, double stepMinutes) {
    settings.intervalMinutes = std::min(settings.intervalMinutes, maxMaskSteps * stepMinutes);
    return settings;
}

namespace {

/// The runs of edges that a later path still needs: 4 bytes per receiver and edge, half of what masks would
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
        maximum_ = std::max(maximum_, maps_.size());
    }

    void dropAfter(std::size_t path) {
        std::erase_if(maps_, [&](const auto& map) { return lastPath_[map.first] <= path; });
    }

    [[nodiscard]] std::size_t maximum() const { return maximum_; }

private:
    std::vector<std::size_t> lastPath_;
    std::map<std::uint32_t, std::vector<MaskRuns>> maps_;
    std::size_t maximum_ = 0;
};

/// One pass over the graph that fills a blank field.
class GraphRun {
public:
    GraphRun(const DirectionGraph& graph, IntervalScene& scene, const Receivers& receivers,
             ShadowField& field, Progress& progress, std::stop_token stop, const StepMemory& memory)
        : graph_(graph),
          scene_(scene),
          receivers_(receivers),
          field_(field),
          progress_(progress),
          stop_(std::move(stop)),
          memory_(isOneDay(graph) ? memory : StepMemory{}),
          maps_(graph),
          tally_(receivers.cells.size()),
          masks_(receivers.cells.size()) {}

    Result<void> run() {
        for (std::size_t path = 0; path < graph_.paths.size(); ++path) {
            if (const auto done = addPath(graph_.paths[path]); !done) return done;
            maps_.dropAfter(path);
            if (stop_.stop_requested()) return cancelled();
        }
        tally_.writeTo(field_, receivers_, {});
        if (PartialSink* sink = findPartialSink(progress_)) sink->take(partial(tally_, {}));
        return {};
    }

    [[nodiscard]] std::size_t maxLiveMaps() const { return maps_.maximum(); }

private:
    Result<void> addPath(const DirectionGraph::Path& path) {
        std::vector<PathLeg> legs;
        for (const auto& leg : path) {
            const bool known = maps_.has(leg.edge);
            if (!known)
                if (const auto done = shade(leg, legs); !done) return done;
            legs.push_back({maps_.of(leg.edge), graph_.edges[leg.edge].sun.steps, leg.breaksRun});
            if (!known) show(legs);
        }
        tally_.addPath(legs);
        return {};
    }

    // `before`: the earlier legs of the same day.
    Result<void> shade(const DirectionGraph::Leg& leg, const std::vector<PathLeg>& before) {
        progress_.report(double(shaded_++) / double(graph_.edges.size()), "shading intervals");
        const DirectionGraph::Edge& edge = graph_.edges[leg.edge];
        PartialSink* sink = findPartialSink(progress_);
        const auto done =
            sink ? scene_.shadeWatched(
                       edge.sun, masks_, stop_,
                       {[sink] { return sink->wants(); },
                        [&](int steps) { sink->take(partialOf(edge, steps, leg.breaksRun, before)); }})
                 : scene_.shade(edge.sun, masks_, stop_);
        if (!done) return done;
        if (memory_.found) memory_.found->resize(graph_.edges.size());
        if (memory_.found) (*memory_.found)[leg.edge] = masks_;
        maps_.keep(leg.edge, tally_.addEdge(masks_, edge));
        return {};
    }

    // `path`: the finished legs of the current day.
    void show(const std::vector<PathLeg>& path) {
        PartialSink* sink = findPartialSink(progress_);
        if (sink && sink->wants()) sink->take(partial(tally_, path));
    }

    // Includes the first few steps of an edge; `path`: the earlier legs of the current day.
    [[nodiscard]] PartialField partialOf(const DirectionGraph::Edge& edge, int steps, bool breaksRun,
                                         std::vector<PathLeg> path) const {
        DirectionGraph::Edge some = edge;
        if (!memory_.around) some.sun.steps = steps;
        IntervalTally tally = tally_;
        const std::vector<MaskRuns> runs = tally.addEdge(beginningOf(edge, steps), some);
        path.push_back({runs, some.sun.steps, breaksRun});
        PartialField shown = partial(std::move(tally), path);
        const double whole = double(tally_.intervals()), part = double(edge.weight) * steps / edge.sun.steps;
        shown.share = (whole + part) / double(graph_.intervals);
        shown.part = fmt::format("{} of {} sun intervals, {} of {} steps of the next", tally_.intervals(),
                                 graph_.intervals, steps, edge.sun.steps);
        return shown;
    }

    // The current masks up to a step; after it no shadow, or that of nearby points of the coarser view.
    [[nodiscard]] std::vector<ShadowMask> beginningOf(const DirectionGraph::Edge& edge, int steps) const {
        std::vector<ShadowMask> masks(masks_.size());
        if (memory_.around) masks = memory_.around->at(std::uint32_t(&edge - graph_.edges.data()));
        const ShadowMask done = fullMask(steps);
        for (std::size_t i = 0; i < masks.size(); ++i) masks[i] = (masks[i] & ~done) | (masks_[i] & done);
        return masks;
    }

    [[nodiscard]] PartialField partial(IntervalTally tally, std::vector<PathLeg> path) const {
        PartialField partial{field_, double(tally.intervals()) / double(graph_.intervals)};
        partial.part = fmt::format("{} of {} sun intervals", tally.intervals(), graph_.intervals);
        const auto rest = restAround(tally, path);
        tally.writeTo(partial.field, receivers_, path);
        partial.wholePeriod = memory_.around != nullptr;
        partial.field.sunlitMinutesPerDay = double(tally.steps()) * field_.stepMinutes / field_.days;
        return partial;
    }

    // Adds the remaining intervals from the coarser view; returns the storage that the added legs refer to.
    std::vector<std::vector<MaskRuns>> restAround(IntervalTally& tally, std::vector<PathLeg>& path) const {
        std::vector<std::vector<MaskRuns>> rest;
        if (!memory_.around || tally.intervals() == graph_.intervals) return rest;
        const DirectionGraph::Path& legs = graph_.paths.front();
        for (std::size_t k = path.size(); k < legs.size(); ++k) {
            const DirectionGraph::Edge& edge = graph_.edges[legs[k].edge];
            rest.push_back(tally.addEdge(memory_.around->at(legs[k].edge), edge));
            path.push_back({rest.back(), edge.sun.steps, legs[k].breaksRun});
        }
        return rest;
    }

    const DirectionGraph& graph_;
    IntervalScene& scene_;
    const Receivers& receivers_;
    ShadowField& field_;
    Progress& progress_;
    std::stop_token stop_;
    StepMemory memory_;
    LiveMaps maps_;
    IntervalTally tally_;
    std::vector<ShadowMask> masks_;  // of the current edge
    std::size_t shaded_ = 0;
};

}  // namespace

GraphEngine::GraphEngine(std::shared_ptr<const IntervalEngine> engine, DirectionGraphSettings settings)
    : engine_(std::move(engine)), settings_(settings) {}

Result<ShadowField> GraphEngine::compute(const City& city, const Receivers& receivers, const SunSteps& sun,
                                         Progress& progress, std::stop_token stop) const {
    return accumulate(city, receivers, sun, progress, std::move(stop), {});
}

Result<ShadowField> GraphEngine::accumulate(const City& city, const Receivers& receivers, const SunSteps& sun,
                                            Progress& progress, std::stop_token stop,
                                            const StepMemory& memory) const {
    const auto graph = buildDirectionGraph(sun, fitToMasks(settings_, sun.stepMinutes));
    if (!graph) return tl::make_unexpected(graph.error());
    const Stopwatch watch;
    auto scene = engine_->prepare(city, receivers, collectDirections(*graph), stop);
    if (!scene) return tl::make_unexpected(scene.error());
    const double build = watch.seconds();
    ShadowField field = makeBlankField(receivers, sun);
    const Cost untouched = field.cost;
    GraphRun run(*graph, **scene, receivers, field, progress, stop, memory);
    if (const auto done = run.run(); !done) return tl::make_unexpected(done.error());

    field.cost = (*scene)->cost();
    field.cost.skipped.insert(untouched.skipped.begin(), untouched.skipped.end());
    field.cost.seconds["build"] += build;
    field.cost.skipped["intervals that share an edge of the direction graph"] =
        graph->intervals - graph->edges.size();
    field.engine = fmt::format("{}; direction graph with {} edges for {} intervals, {} maps alive at most",
                               engine_->describe(), graph->edges.size(), graph->intervals, run.maxLiveMaps());
    return field;
}

}  // namespace noonmark
