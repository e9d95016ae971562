#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <memory>
#include <span>
#include <vector>

#include "core/engines/accrual/accrual_settings.h"
#include "core/engines/accrual/interval_casters.h"
#include "core/engines/accrual/map_frame.h"
#include "core/engines/accrual/surface_lookup.h"
#include "core/engines/common/shadow_mask.h"
#include "render/gl/gl_context.h"

namespace noonmark {

/// What OpenGL was asked to do.
struct GlWork {
    std::uint64_t passes = 0;  ///< maps cleared and drawn, and receivers tested against them
    std::uint64_t drawCalls = 0;
    std::uint64_t vertices = 0;  ///< through the vertex shader, as indexed
    std::uint64_t lookups = 0;   ///< receivers x steps
};

/// Depth maps of an interval in OpenGL and the receivers' lookups in them: `layers` steps at a time, so one
/// layer gives a shadow map for each step, and as many layers as steps give a shadow accrual map in a single
/// draw (paper, section 4). Both run the same shaders. All calls with the context current, on one thread at a
/// time.
class DepthMaps {
public:
    /// Error: no memory for so many maps, or a driver that refuses the shaders.
    static Result<std::unique_ptr<DepthMaps>> make(const GlLimits& limits, int columns, int rows, int layers);
    ~DepthMaps();

    /// The plane of the maps to come, and who is tested against them.
    void take(const MapFrame& frame, const PlacedSurface& receivers, const AccrualSettings& settings);

    /// What is drawn, and the suns of the steps.
    void take(const IntervalCasters& casters, const SunInterval& interval);

    /// Draws the maps of steps [first, first + count); count is at most `layers`.
    void draw(int first, int count);

    /// Sets the receivers' bits of those steps; first = 0 begins anew.
    void lookUp(int first, int count);

    /// Until the device has done what it was asked to.
    void wait() const;

    /// Waits for the device. Error when something went wrong on the way, as a device without memory.
    Result<void> read(std::span<ShadowMask> masks);

    /// Depths of one layer as drawn last, rows x columns, 0 = empty, larger is nearer to the sun.
    [[nodiscard]] std::vector<float> depths(int layer) const;

    [[nodiscard]] const GlWork& work() const;

private:
    struct Parts;
    explicit DepthMaps(std::unique_ptr<Parts> parts);
    std::unique_ptr<Parts> parts_;
};

}  // namespace noonmark
