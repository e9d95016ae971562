#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/engines/projected/filling/caster_fill_hwy.cpp"
#include <hwy/foreach_target.h>

#include <glm/common.hpp>

#include "core/engines/projected/filling/step_filler.h"
#include "core/simd/kernel.h"

// After kernel.h.
#include "core/engines/projected/casters/caster_shaping-inl.h"
#include "core/engines/projected/filling/convex_fill-inl.h"

HWY_BEFORE_NAMESPACE();
namespace noonmark::HWY_NAMESPACE {
namespace {

HWY_INLINE CasterRing ringOf(const ShadowCasters& casters, const ShadowCaster& caster) {
    return {casters.pointsOf(caster), casters.edgesOf(caster)};
}

// Processes steps with the same far edges together.
HWY_NOINLINE int fillApart(const ShadowCaster& caster, const FillTask& task, FarEdges& far) {
    const auto same = [](const EdgeArc& a, const EdgeArc& b) { return a.first == b.first && a.end == b.end; };
    const CasterRing ring = ringOf(task.casters, caster);
    Shaping shaping(task.throws);
    int rows = 0;
    for (std::size_t step = 0; step < stepsTogether;) {
        const EdgeArc arc = ring.findFar(task.throws, step);
        far = ring.facingApart(arc);
        const std::size_t first = step++;
        while (step < stepsTogether && same(ring.findFar(task.throws, step), arc)) ++step;
        if (!shaping.shape(caster, ring, far)) continue;
        for (std::size_t other = 0; other < stepsTogether; ++other)
            if (other < first || other >= step) shaping.leaveOut(other);
        rows += fillShape(shaping.made(), task.layout, task.band, task.rasters);
    }
    return rows;
}

HWY_INLINE int fillOne(const ShadowCaster& caster, Shaping& shaping, const FillTask& task, FarEdges& far) {
    if (caster.kind == ShadowCaster::Kind::face) {
        shaping.shapeFace(caster, task.casters.pointsOf(caster));
    } else {
        const CasterRing ring = ringOf(task.casters, caster);
        if (!shaping.areFar(ring, far.far)) return fillApart(caster, task, far);
        if (!shaping.shape(caster, ring, far)) return 0;
    }
    return fillShape(shaping.made(), task.layout, task.band, task.rasters);
}

}  // namespace

// far: one entry per caster of the city.
std::uint64_t fillCasters(std::span<const std::uint32_t> casters, const FillTask& task, FarEdges* far) {
    Shaping shaping(task.throws);
    std::uint64_t rows = 0;
    for (const std::uint32_t i : casters)
        rows += std::uint64_t(fillOne(task.casters.casters[i], shaping, task, far[i]));
    return rows;
}

}  // namespace noonmark::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace noonmark {

SweptBox computeSweptBox(const ShadowCaster& caster, const StepOffsets& throws) {
    const double bottom = caster.bottomM > 0 ? double(caster.bottomM) : -behindWallM, top = caster.topM;
    const glm::dvec2 ofBottom = glm::min(throws.low * bottom, throws.high * bottom),
                     toBottom = glm::max(throws.low * bottom, throws.high * bottom);
    return {caster.low + glm::min(ofBottom, throws.low * top),
            caster.high + glm::max(toBottom, throws.high * top)};
}

CasterFill::CasterFill(const ShadowCasters& casters) : casters_(casters), far_(casters.casters.size()) {}

NOONMARK_KERNEL(fillCasters);
std::uint64_t CasterFill::fill(std::span<const std::uint32_t> casters, const StepOffsets& throws,
                               const BitLayout& layout, const RowBand& band,
                               std::span<std::uint64_t> rasters) {
    return NOONMARK_CALL(fillCasters)(casters, {casters_, throws, layout, band, rasters}, far_.data());
}

}  // namespace noonmark
#endif
