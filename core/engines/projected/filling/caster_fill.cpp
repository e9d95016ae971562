#include "core/engines/projected/filling/caster_fill.h"

#include <algorithm>
#include <glm/common.hpp>

#include "core/engines/projected/casters/caster_shaping.h"
#include "core/engines/projected/filling/convex_fill.h"

namespace noonmark {

SweptBox computeSweptBox(const ShadowCaster& caster, const StepOffsets& throws) {
    const double bottom = caster.bottomM > 0 ? double(caster.bottomM) : -behindWallM, top = caster.topM;
    const glm::dvec2 ofBottom = glm::min(throws.low * bottom, throws.high * bottom),
                     toBottom = glm::max(throws.low * bottom, throws.high * bottom);
    return {caster.low + glm::min(ofBottom, throws.low * top),
            caster.high + glm::max(toBottom, throws.high * top)};
}

CasterFill::CasterFill(const ShadowCasters& casters) : casters_(casters), far_(casters.casters.size()) {}

inline bool CasterFill::Ring::isFar(std::size_t edge, const StepOffsets& throws, std::size_t step) const {
    return throws.at.x[step] * edges[edge].along.y - throws.at.y[step] * edges[edge].along.x > 0;
}

CasterFill::Arc CasterFill::Ring::findFar(const StepOffsets& throws, std::size_t step) const {
    const std::size_t count = edges.size();
    for (std::size_t i = 0; i < count; ++i) {
        if (!isFar(i, throws, step) || isFar(before(i), throws, step)) continue;
        std::size_t end = after(i);
        while (isFar(end, throws, step)) end = after(end);
        return {.first = std::uint32_t(i), .end = std::uint32_t(end)};
    }
    return {};
}

void CasterFill::Ring::bound(Arc& arc) const {
    arc.low = arc.high = points[arc.end];
    std::size_t i = arc.first;
    do {
        arc.low = glm::min(arc.low, points[i]);
        arc.high = glm::max(arc.high, points[i]);
        i = after(i);
    } while (i != arc.end);
}

CasterFill::FarEdges CasterFill::Ring::facingApart(const Arc& facing) const {
    FarEdges kept{facing, {.first = facing.end, .end = facing.first}, {}};
    if (facing.first == facing.end)  // all are near: begins at the lowest point, so that each side runs only
                                     // upwards or only downwards
        kept.near.first = kept.near.end =
            std::uint32_t(std::ranges::min_element(points, {}, &glm::dvec2::y) - points.begin());
    bound(kept.far);
    bound(kept.near);
    kept.chord = RingEdge(points[facing.end], points[facing.first]);
    return kept;
}

[[gnu::always_inline]] inline CasterFill::Ring CasterFill::parseRing(const ShadowCaster& caster) const {
    return {casters_.pointsOf(caster), casters_.edgesOf(caster)};
}

std::uint64_t CasterFill::fill(std::span<const std::uint32_t> casters, const StepOffsets& throws,
                               const BitLayout& layout, const RowBand& band,
                               std::span<std::uint64_t> rasters) {
    std::uint64_t rows = 0;
    runWithWidestRegisters([&](auto registers) __attribute__((always_inline)) {
        const Task task{throws, layout, band, rasters};
        Shaping<decltype(registers)> shaping(throws);
        for (const std::uint32_t caster : casters) rows += std::uint64_t(fillOne(caster, shaping, task));
    });
    return rows;
}

template <class Register>
[[gnu::always_inline]] inline int CasterFill::fillOne(std::uint32_t index, Shaping<Register>& shaping,
                                                      const Task& task) {
    const ShadowCaster& caster = casters_.casters[index];
    if (caster.kind == ShadowCaster::Kind::face) {
        shaping.shapeFace(caster, casters_.pointsOf(caster));
        return fillShape<Register>(shaping.made(), task.layout, task.band, task.rasters);
    }
    const Ring ring = parseRing(caster);
    if (!shaping.areFar(ring, far_[index].far)) return fillApart(index, task);
    if (!shaping.shape(caster, ring, far_[index])) return 0;
    return fillShape<Register>(shaping.made(), task.layout, task.band, task.rasters);
}

// Processes steps with the same far edges together.
int CasterFill::fillApart(std::uint32_t index, const Task& task) {
    int rows = 0;
    runWithWidestRegisters([&](auto registers) __attribute__((always_inline)) {
        using Register = decltype(registers);
        const auto same = [](const Arc& a, const Arc& b) { return a.first == b.first && a.end == b.end; };
        const ShadowCaster& caster = casters_.casters[index];
        const Ring ring = parseRing(caster);
        Shaping<Register> shaping(task.throws);
        for (std::size_t step = 0; step < stepsTogether;) {
            const Arc far = ring.findFar(task.throws, step);
            far_[index] = ring.facingApart(far);
            const std::size_t first = step++;
            while (step < stepsTogether && same(ring.findFar(task.throws, step), far)) ++step;
            if (!shaping.shape(caster, ring, far_[index])) continue;
            for (std::size_t other = 0; other < stepsTogether; ++other)
                if (other < first || other >= step) shaping.leaveOut(other);
            rows += fillShape<Register>(shaping.made(), task.layout, task.band, task.rasters);
        }
    });
    return rows;
}

}  // namespace noonmark
