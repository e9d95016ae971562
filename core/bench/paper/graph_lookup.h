#pragma once

#include <map>
#include <utility>

#include "core/engines/graph/direction_graph.h"

namespace noonmark::bench {

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

}  // namespace noonmark::bench
