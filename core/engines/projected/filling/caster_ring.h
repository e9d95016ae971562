#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <span>

#include "core/engines/projected/casters/ring_lines.h"
#include "core/engines/projected/filling/step_lanes.h"

namespace noonmark {

/// Edges [first, end) of a ring, wrapping around, and bounds of their points.
struct EdgeArc {
    std::uint32_t first = 0, end = 0;
    glm::dvec2 low{}, high{};
};

/// The edges of a ring that face away from the sun, and the others; empty: first == end.
struct FarEdges {
    EdgeArc far, near;
    RingEdge chord;  ///< from the end of the far edges to their beginning
};

/// A caster's ring: counter-clockwise, in cells.
struct CasterRing {
    std::span<const glm::dvec2> points;
    std::span<const RingEdge> edges;
    [[nodiscard]] std::size_t before(std::size_t edge) const { return (edge ? edge : edges.size()) - 1; }
    [[nodiscard]] std::size_t after(std::size_t edge) const {
        return edge + 1 == edges.size() ? 0 : edge + 1;
    }
    /// The edges that face away from the sun at one of the eight steps; without bounds.
    [[nodiscard]] EdgeArc findFar(const StepOffsets& throws, std::size_t step) const;
    [[nodiscard]] FarEdges facingApart(const EdgeArc& far) const;

private:
    [[nodiscard]] bool isFar(std::size_t edge, const StepOffsets& throws, std::size_t step) const;
    void bound(EdgeArc& arc) const;
};

}  // namespace noonmark
