#include "core/engines/projected/filling/caster_fill.h"

#include <algorithm>
#include <glm/common.hpp>

namespace noonmark {

inline bool CasterRing::isFar(std::size_t edge, const StepOffsets& throws, std::size_t step) const {
    return throws.at.x[step] * edges[edge].along.y - throws.at.y[step] * edges[edge].along.x > 0;
}

EdgeArc CasterRing::findFar(const StepOffsets& throws, std::size_t step) const {
    const std::size_t count = edges.size();
    for (std::size_t i = 0; i < count; ++i) {
        if (!isFar(i, throws, step) || isFar(before(i), throws, step)) continue;
        std::size_t end = after(i);
        while (isFar(end, throws, step)) end = after(end);
        return {.first = std::uint32_t(i), .end = std::uint32_t(end)};
    }
    return {};
}

void CasterRing::bound(EdgeArc& arc) const {
    arc.low = arc.high = points[arc.end];
    std::size_t i = arc.first;
    do {
        arc.low = glm::min(arc.low, points[i]);
        arc.high = glm::max(arc.high, points[i]);
        i = after(i);
    } while (i != arc.end);
}

FarEdges CasterRing::facingApart(const EdgeArc& far) const {
    FarEdges kept{far, {.first = far.end, .end = far.first}, {}};
    if (far.first == far.end)  // all are near: begins at the lowest point, so that each side runs only
                               // upwards or only downwards
        kept.near.first = kept.near.end =
            std::uint32_t(std::ranges::min_element(points, {}, &glm::dvec2::y) - points.begin());
    bound(kept.far);
    bound(kept.near);
    kept.chord = RingEdge(points[far.end], points[far.first]);
    return kept;
}

}  // namespace noonmark
