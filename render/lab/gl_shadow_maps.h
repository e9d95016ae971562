#pragma once

// The folder render/lab/ contains the engines that draw with OpenGL, without a window and without Qt. This
// file implements and registers them, depth_maps.h draws the depth maps with the programs of gl_program.h,
// which also wraps OpenGL objects and errors, and gl_context.h opens the device.

#include <memory>

#include "core/engines/api/engine_registry.h"
#include "core/lab/accrual/accrual_settings.h"
#include "core/lab/graph/interval_engine.h"
#include "render/lab/gl_context.h"

namespace noonmark {

enum class GlPasses {
    /// Conventional shadow maps: draws a depth map per step and tests all receivers against it.
    oneAStep,
    /// Shadow accrual map: one draw fills the maps of all steps, one pass tests all receivers against them.
    /// In software it draws a few steps at a time, so that it can be cancelled.
    oneAnInterval,
};

/// Shadow maps in OpenGL, for flat ground. Both kinds cull in the same way and run the same shaders, so they
/// differ only in the number of passes; their masks are bit-identical.
class GlShadowMaps final : public IntervalEngine {
public:
    /// Error: a setting is out of its own or the device's range, or there is no OpenGL 4.3.
    static Result<std::shared_ptr<const GlShadowMaps>> make(GlPasses passes, const AccrualSettings& settings);

    [[nodiscard]] Result<std::unique_ptr<IntervalScene>> prepare(const City& city, const Receivers& receivers,
                                                                 const SunSteps& directions,
                                                                 std::stop_token stop) const override;
    [[nodiscard]] std::string_view name() const override { return "Shadow maps"; }
    [[nodiscard]] std::string describe() const override;
    [[nodiscard]] const GlLimits& limits() const { return context_->limits(); }

private:
    GlShadowMaps(GlPasses passes, const AccrualSettings& settings, std::shared_ptr<const GlContext> context);
    GlPasses passes_;
    AccrualSettings settings_;
    std::shared_ptr<const GlContext> context_;
};

/// The OpenGL engines that complement coreEngines(): "shadow-map-gl", with which the paper compares accrual
/// maps, and "sam-gl". Empty without OpenGL 4.3. Software OpenGL counts too: it is slower than the CPU
/// engines but allows the comparison. The first call looks for a device, about 50 ms.
const EngineList& glEngines();

}  // namespace noonmark
