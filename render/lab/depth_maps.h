#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <memory>
#include <span>
#include <vector>

#include "core/engines/common/run_counter.h"
#include "core/engines/depths/caster_faces.h"
#include "core/engines/depths/map_frame.h"
#include "core/lab/accrual/accrual_settings.h"
#include "core/lab/accrual/surface_accrual.h"
#include "render/lab/gl_context.h"

namespace noonmark {

/// Counts of the work submitted to OpenGL.
struct GlWork {
    std::uint64_t passes = 0;  ///< maps cleared and drawn, plus tests of the receivers against them
    std::uint64_t drawCalls = 0;
    std::uint64_t vertices = 0;  ///< processed by the vertex shader, as indexed
    std::uint64_t lookups = 0;   ///< receivers x steps
};

/// Depth maps of an interval in OpenGL and the lookups of the receivers in them, `layers` steps at a time.
/// One layer gives a shadow map per step; as many layers as steps give a shadow accrual map in a single draw
/// (paper, section 4). Both use the same shaders. All calls need the current context, on one thread at a
/// time.
class DepthMaps {
public:
    /// Error: not enough memory for that many maps, or the driver rejects the shaders.
    static Result<std::unique_ptr<DepthMaps>> make(const GlLimits& limits, int columns, int rows, int layers);
    ~DepthMaps();

    /// Sets the plane of the following maps and the receivers tested against them.
    void take(const MapFrame& frame, const PlacedSurface& receivers, const AccrualSettings& settings);

    /// Sets the geometry to draw and the sun directions of the steps.
    void take(const IntervalCasters& casters, const SunInterval& interval);

    /// Draws the maps of steps [first, first + count); count is at most `layers`.
    void draw(int first, int count);

    /// Sets the receivers' bits for those steps; first = 0 clears all bits first.
    void lookUp(int first, int count);

    /// Waits until the device has completed its work.
    void wait() const;

    /// Waits for the device and reads the masks. Error: an OpenGL operation failed, for example for lack of
    /// memory.
    Result<void> read(std::span<ShadowMask> masks);

    /// Depths of one layer as last drawn, rows x columns; 0 = empty, larger = nearer to the sun.
    [[nodiscard]] std::vector<float> depths(int layer) const;

    [[nodiscard]] const GlWork& work() const;

private:
    struct Parts;
    explicit DepthMaps(std::unique_ptr<Parts> parts);
    std::unique_ptr<Parts> parts_;
};

}  // namespace noonmark
