#include "render/gl/gl_engines.h"

#include <algorithm>

#include "core/describe/text.h"
#include "core/engines/accrual/interval_options.h"
#include "core/engines/graph/graph_engine.h"
#include "render/gl/gl_shadow_maps.h"

namespace noonmark {

namespace {

EngineEntry engineOf(EngineInfo info, GlPasses passes, const GlLimits& limits) {
    info.bytesPerCell = accrualBytesPerCell;
    info.options = accrualOptions(std::min(limits.mapSize, AccrualSettings::maxMapSize));
    return {std::move(info), [passes](const EngineSettings& settings) -> Result<std::unique_ptr<Engine>> {
                const auto maps = GlShadowMaps::make(passes, readAccrualSettings(settings));
                if (!maps) return tl::make_unexpected(maps.error());
                return std::make_unique<GraphEngine>(*maps, readGraphSettings(settings));
            }};
}

EngineList findEngines() {
    const auto context = GlContext::make();
    if (!context) return {};
    const GlLimits& limits = (*context)->limits();
    return {
        engineOf(
            {"shadow-map-gl", NM_TEXT("Shadow maps (OpenGL)"),
             NM_TEXT(
                 "Draws one depth map per step and tests every cell against it: the method that the paper "
                 "compares accrual maps with")},
            GlPasses::oneAStep, limits),
        engineOf({"sam-gl", NM_TEXT("Shadow accrual map (OpenGL)"),
                  NM_TEXT("One draw on the graphics device fills the depth maps of all steps of an hour")},
                 GlPasses::oneAnInterval, limits)};
}

}  // namespace

const EngineList& glEngines() {
    static const EngineList engines = findEngines();
    return engines;
}

}  // namespace noonmark
