#pragma once

#include <memory>

#include "core/engines/accrual/accrual_settings.h"
#include "core/engines/common/interval_engine.h"
#include "render/gl/gl_context.h"

namespace noonmark {

enum class GlPasses {
    /// The paper's baseline: for each step a depth map is drawn and all receivers are tested against it.
    oneAStep,
    /// Shadow accrual map: one draw fills the maps of all steps, one pass tests all receivers against them.
    /// In
    /// software a few steps at a time, so that it can be stopped.
    oneAnInterval,
};

/// Shadow maps in OpenGL, for flat ground. Both kinds cull alike and run the same shaders, so what they
/// differ in is the number of passes; their masks are the same to the last bit.
class GlShadowMaps final : public IntervalEngine {
public:
    /// Error when a setting is out of range, of the device's range too, or there is no OpenGL 4.3.
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

}  // namespace noonmark
