#pragma once

#include <span>
#include <vector>

#include "core/accumulate/projected/bit_raster.h"
#include "core/accumulate/projected/shadow_casters.h"
#include "core/accumulate/projected/step_lanes.h"

namespace noonmark {

/// A rectangle of cells.
struct SweptBox {
    glm::dvec2 low, high;
};
/// Holds the shadow of a caster at all these steps.
SweptBox sweptBox(const ShadowCaster& caster, const StepThrows& throws);

/// Throws the shadows of casters at eight steps of the sun at a time. Which edges face away from it changes
/// rarely, so it is kept from one time to the next. One for each thread.
class CasterFill {
public:
    explicit CasterFill(const ShadowCasters& casters);

    /// Fills the shadows of some casters into rasters (convex_fill.h) that have the cells under standing
    /// casters set already, or do without them. Returns the number of rows looked at. Cost: 50 ns a caster,
    /// and up to 10 ns a row. The same bits on every instruction set.
    std::uint64_t fill(std::span<const std::uint32_t> casters, const StepThrows& throws,
                       const BitLayout& layout, const RowBand& band, std::span<std::uint64_t> rasters);

private:
    /// Edges [first, end), round a ring, and bounds of their points.
    struct Arc {
        std::uint32_t first = 0, end = 0;
        glm::dvec2 low{}, high{};
    };
    /// The edges of a ring that face away from the sun, and the others; none: first == end.
    struct FarEdges {
        Arc far, near;
        RingEdge chord;  ///< from the far edges' end to their beginning
    };
    /// What casters have in common at the eight steps: the way of a shadow in rows.
    struct Way {
        StepDoubles slope, up;
        explicit Way(const StepThrows& throws);
    };
    /// A ring on its way from `near` to `far`, cells.
    struct Sweep {
        const ShadowCaster& caster;
        std::span<const glm::dvec2> points;
        std::span<const RingEdge> edges;
        const StepThrows& throws;
        StepPoints far;
        glm::dvec2 farLow, farHigh;  ///< bounds of its moves
        StepPoints near;
        glm::dvec2 nearLow, nearHigh;
        void beginAt(double bottomM);
        [[nodiscard]] bool isFar(std::size_t edge, std::size_t step) const;
        [[nodiscard]] bool areFar(const Arc& arc) const;
        [[nodiscard]] Arc findFar(std::size_t step) const;
        [[nodiscard]] std::size_t before(std::size_t edge) const { return (edge ? edge : edges.size()) - 1; }
        [[nodiscard]] std::size_t after(std::size_t edge) const {
            return edge + 1 == edges.size() ? 0 : edge + 1;
        }
        void bound(Arc& arc) const;
        [[nodiscard]] FarEdges facingApart(const Arc& facing) const;
    };
    Sweep sweepOf(const ShadowCaster& caster, const StepThrows& throws) const;
    int fillOne(std::uint32_t caster, const StepThrows& throws, const Way& way, const BitLayout& layout,
                const RowBand& band, std::span<std::uint64_t> rasters);
    int fillApart(std::uint32_t caster, Sweep& sweep, const Way& way, const BitLayout& layout,
                  const RowBand& band, std::span<std::uint64_t> rasters);
    bool shape(Sweep& sweep, const FarEdges& edges, const Way& way);
    void shapeFace(const ShadowCaster& caster, const StepThrows& throws);
    void clear();
    void bound(glm::dvec2 low, glm::dvec2 high, const StepPoints& at, glm::dvec2 atLow, glm::dvec2 atHigh);
    void addSide(const StepPoints& a, const StepPoints& b, const StepDoubles& turn);
    void addStrip(const Sweep& sweep, glm::dvec2 first, glm::dvec2 last, const Way& way);
    void addEnds(const Sweep& sweep, const Arc& arc, std::size_t end);
    void addChord(const Sweep& sweep, const RingEdge& chord, glm::dvec2 first, glm::dvec2 last);

    const ShadowCasters& casters_;
    std::vector<FarEdges> far_;  // of each caster, as last seen
    StepShape shape_;
};

}  // namespace noonmark
