#pragma once

#include <span>
#include <vector>

#include "core/accumulate/projected/convex_fill.h"
#include "core/accumulate/projected/shadow_casters.h"

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

    /// Fills the shadows of one caster into rasters (convex_fill.h) that have the cells under standing
    /// casters set already. Returns the number of rows looked at. Cost: 100 ns, and up to 10 ns a row.
    int fill(std::uint32_t caster, const StepThrows& throws, const BitLayout& layout, const RowBand& band,
             std::span<std::uint64_t> rasters);

private:
    /// The edges [first, end), round the ring, that face away from the sun; none: first == end.
    struct FarEdges {
        std::uint32_t first = 0, end = 0;
        bool operator==(const FarEdges&) const = default;
    };
    /// A ring on its way from `near` to `far`, cells.
    struct Sweep {
        const ShadowCaster& caster;
        std::span<const glm::dvec2> points;
        std::span<const RingEdge> edges;
        StepPoints near, far, move;
        glm::dvec2 nearLow, nearHigh, farLow, farHigh;  ///< bounds
        [[nodiscard]] bool isFar(std::size_t edge, std::size_t step) const;
        [[nodiscard]] bool areFar(const FarEdges& edges) const;
        [[nodiscard]] FarEdges findFar(std::size_t step) const;
        [[nodiscard]] std::size_t before(std::size_t edge) const { return (edge ? edge : edges.size()) - 1; }
    };
    Sweep sweepOf(const ShadowCaster& caster, const StepThrows& throws) const;
    bool shape(const Sweep& sweep, const FarEdges& far);
    void shapeFace(const ShadowCaster& caster, const StepThrows& throws);
    void clear();
    void bound(glm::dvec2 low, glm::dvec2 high, const StepPoints& at, glm::dvec2 atLow, glm::dvec2 atHigh);
    void addSide(const StepPoints& a, const StepPoints& b, const StepDoubles& turn);
    void addStrip(const Sweep& sweep, glm::dvec2 first, glm::dvec2 last);
    void addEnds(const Sweep& sweep, std::size_t first, std::size_t end, bool atFar);

    const ShadowCasters& casters_;
    std::vector<FarEdges> far_;  // of each caster, as last seen
    StepShape shape_;
};

}  // namespace noonmark
