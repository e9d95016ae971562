#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <span>
#include <vector>

#include "core/engines/projected/casters/ring_lines.h"
#include "core/engines/projected/casters/shadow_casters.h"
#include "core/engines/projected/filling/bit_raster.h"
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

/// The shadow of a wall on the ground begins this far behind the wall, towards the sun, as a height in
/// metres: the rays of a receiver just behind the wall begin inside the building (placeRayOrigin()). No
/// receiver lies in that strip.
inline constexpr double behindWallM = 1e-3;

/// A rectangle of cells.
struct SweptBox {
    glm::dvec2 low, high;
};
/// Bounds of a caster's shadow over all these steps.
SweptBox computeSweptBox(const ShadowCaster& caster, const StepOffsets& throws);

/// Eight steps, and the rasters for their shadows.
struct FillTask {
    const ShadowCasters& casters;
    const StepOffsets& throws;
    BitLayout layout;
    RowBand band;
    std::span<std::uint64_t> rasters;
};

/// Fills the shadows of casters, eight steps of the sun at a time. The edges that face away from the sun
/// change rarely, so they are remembered from call to call. One per thread.
class CasterFill {
public:
    explicit CasterFill(const ShadowCasters& casters);

    /// Fills the shadows of some casters into rasters (convex_fill-inl.h). Cells under standing casters must
    /// already be set, or are not needed. Returns the number of rows visited. Cost: 50 ns per caster, and up
    /// to 10 ns per row. The same bits on every instruction set.
    std::uint64_t fill(std::span<const std::uint32_t> casters, const StepOffsets& throws,
                       const BitLayout& layout, const RowBand& band, std::span<std::uint64_t> rasters);

private:
    const ShadowCasters& casters_;
    std::vector<FarEdges> far_;  // result of the last call, per caster
};

}  // namespace noonmark
