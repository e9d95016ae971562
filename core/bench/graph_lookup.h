#pragma once

#include <map>
#include <utility>

#include "core/accumulate/direction_graph.h"

namespace noonmark::bench {

/// Which edge of a merged direction graph an interval takes.
class GraphLookup {
public:
    /// The graph outlives it.
    GraphLookup(const DirectionGraph& graph, double boundDeg) : boundDeg_(boundDeg) {
        for (const auto& edge : graph.edges) edges_[{{edge.fromBin, edge.toBin}, edge.sun.steps}] = &edge;
    }

    /// The edge of the interval of `steps` steps from `first` to `last`; null where no interval of the
    /// graph's period took it.
    [[nodiscard]] const DirectionGraph::Edge* find(const SunStep& first, const SunStep& last,
                                                   int steps) const {
        const auto found = edges_.find({{binOf(first), binOf(last)}, steps});
        return found == edges_.end() ? nullptr : found->second;
    }

private:
    using Key = std::pair<std::pair<std::uint32_t, std::uint32_t>, int>;

    [[nodiscard]] std::uint32_t binOf(const SunStep& step) const {
        return noonmark::binOf(double(step.azimuthDeg), double(step.altitudeDeg), boundDeg_);
    }

    double boundDeg_;
    std::map<Key, const DirectionGraph::Edge*> edges_;
};

}  // namespace noonmark::bench
