#include "render/gl/gl_engines.h"

#include <algorithm>

#include "core/describe/text.h"
#include "core/engines/accrual/accrual_settings.h"
#include "core/engines/graph/graph_engine.h"
#include "render/gl/gl_shadow_maps.h"

namespace noonmark {

namespace {

EngineEntry mapsOf(EngineInfo info, GlPasses passes, const GlLimits& limits) {
    info.bytesPerCell = accrualBytesPerCell;
    EngineEntry entry =
        engineOf(std::move(info), throughGraph(accrualFields()),
                 [passes](const ThroughGraph<AccrualSettings>& settings) -> Result<std::unique_ptr<Engine>> {
                     const auto maps = GlShadowMaps::make(passes, settings.own);
                     if (!maps) return tl::make_unexpected(maps.error());
                     return std::make_unique<GraphEngine>(*maps, settings.graph);
                 });
    ValueRange& sizes = *std::ranges::find(entry.info.options, "map", &Field::key)->range;
    sizes.max = std::min(sizes.max, double(limits.mapSize));
    return entry;
}

EngineList findEngines() {
    const auto context = GlContext::make();
    if (!context) return {};
    const GlLimits& limits = (*context)->limits();
    return {
        mapsOf({"shadow-map-gl", NM_TEXT("Shadow maps (OpenGL)"),
                NM_TEXT(
                    "Draws one depth map per step and tests every cell against it: the method that the paper "
                    "compares accrual maps with")},
               GlPasses::oneAStep, limits),
        mapsOf({"sam-gl", NM_TEXT("Shadow accrual map (OpenGL)"),
                NM_TEXT("One draw on the graphics device fills the depth maps of all steps of an hour")},
               GlPasses::oneAnInterval, limits)};
}

}  // namespace

const EngineList& glEngines() {
    static const EngineList engines = findEngines();
    return engines;
}

}  // namespace noonmark
