#include "core/accumulate/attributed_shadow.h"

#include "core/accumulate/graph_directions.h"

namespace noonmark {

namespace {

AttributedShadow summed(const std::vector<std::uint64_t>& cellSteps, double minM2ACellStep) {
    AttributedShadow shadow;
    for (const std::uint64_t count : cellSteps) {
        shadow.minM2.push_back(double(count) * minM2ACellStep);
        shadow.totalMinM2 += shadow.minM2.back();
    }
    return shadow;
}

}  // namespace

Result<AttributedShadow> attributedShadow(const IntervalEngine& engine,
                                          const DirectionGraphSettings& settings, const City& city,
                                          const Receivers& receivers, const SunSteps& sun, Progress& progress,
                                          std::stop_token stop) {
    const auto graph = directionGraph(sun, fitting(settings, sun.stepMinutes));
    if (!graph) return tl::make_unexpected(graph.error());
    const auto scene = engine.prepare(city, receivers, directionsOf(*graph), stop);
    if (!scene) return tl::make_unexpected(scene.error());
    std::vector<std::uint64_t> all(city.buildings.size()), once;
    for (std::size_t i = 0; i < graph->edges.size(); ++i) {
        once.assign(all.size(), 0);
        if (const auto done = (*scene)->attribute(graph->edges[i].sun, once, stop); !done)
            return tl::make_unexpected(done.error());
        for (std::size_t building = 0; building < all.size(); ++building)
            all[building] += once[building] * graph->edges[i].weight;
        progress.report(double(i + 1) / double(graph->edges.size()), "finding who throws the shadows");
    }
    return summed(all, sun.stepMinutes * receivers.grid.cellAreaM2());
}

}  // namespace noonmark
