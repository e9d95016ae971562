#pragma once

#include <span>
#include <vector>

#include "core/engines/projected/casters/shadow_casters.h"
#include "core/engines/projected/filling/bit_raster.h"
#include "core/engines/projected/filling/step_lanes.h"

namespace noonmark {

/// A rectangle of cells.
struct SweptBox {
    glm::dvec2 low, high;
};
/// Bounds of a caster's shadow over all these steps.
SweptBox computeSweptBox(const ShadowCaster& caster, const StepOffsets& throws);

/// Fills the shadows of casters, eight steps of the sun at a time. The edges that face away from the sun
/// change rarely, so they are remembered from call to call. One per thread.
class CasterFill {
public:
    explicit CasterFill(const ShadowCasters& casters);

    /// Fills the shadows of some casters into rasters (convex_fill.h). Cells under standing casters must
    /// already be set, or are not needed. Returns the number of rows visited. Cost: 50 ns per caster, and up
    /// to 10 ns per row. The same bits on every instruction set.
    std::uint64_t fill(std::span<const std::uint32_t> casters, const StepOffsets& throws,
                       const BitLayout& layout, const RowBand& band, std::span<std::uint64_t> rasters);

private:
    /// Edges [first, end) of a ring, wrapping around, and bounds of their points.
    struct Arc {
        std::uint32_t first = 0, end = 0;
        glm::dvec2 low{}, high{};
    };
    /// The edges of a ring that face away from the sun, and the others; empty: first == end.
    struct FarEdges {
        Arc far, near;
        RingEdge chord;  ///< from the end of the far edges to their beginning
    };
    /// A caster's ring.
    struct Ring {
        std::span<const glm::dvec2> points;
        std::span<const RingEdge> edges;
        [[nodiscard]] std::size_t before(std::size_t edge) const { return (edge ? edge : edges.size()) - 1; }
        [[nodiscard]] std::size_t after(std::size_t edge) const {
            return edge + 1 == edges.size() ? 0 : edge + 1;
        }
        [[nodiscard]] bool isFar(std::size_t edge, const StepOffsets& throws, std::size_t step) const;
        [[nodiscard]] Arc findFar(const StepOffsets& throws, std::size_t step) const;
        void bound(Arc& arc) const;
        [[nodiscard]] FarEdges facingApart(const Arc& facing) const;
    };
    /// The eight steps and the rasters for their shadows.
    struct Task {
        const StepOffsets& throws;
        BitLayout layout;
        RowBand band;
        std::span<std::uint64_t> rasters;
    };
    template <class Register>
    class Shaping;  // caster_shaping.h
    template <class Register>
    int fillOne(std::uint32_t caster, Shaping<Register>& shaping, const Task& task);
    int fillApart(std::uint32_t caster, const Task& task);
    [[nodiscard]] Ring parseRing(const ShadowCaster& caster) const;

    const ShadowCasters& casters_;
    std::vector<FarEdges> far_;  // result of the last call, per caster
};

}  // namespace noonmark
