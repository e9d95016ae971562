#pragma once

#include "core/base/result.h"
#include "core/describe/field.h"
#include "core/engines/depths/caster_faces.h"

namespace noonmark {

/// Settings of shadow accrual maps and of single shadow maps.
struct AccrualSettings {
    static constexpr int minMapSize = 16;
    static constexpr int maxMapSize = 8192;  ///< on the processor; a graphics device may allow less
    static constexpr float maxSlopeBias = 16;

    /// Texels per side, 16 to 8192. Source of the default: paper, section 7.2.
    int mapSize = 1024;
    /// How much closer to the sun than a receiver an occluder must be to shade it: metres along the normal of
    /// the map's plane, 0 to 10.
    float biasM = 0.001F;
    /// Additional bias for surfaces at grazing sun, in texels that the bias compensates for, 0 to 16. 0.5 is
    /// just enough to prevent a plane from shading itself.
    float slopeBias = 0;
    CasterSide side = CasterSide::awayFromSun;
    /// For ground grids no larger than the map: one texel per cell, aligned with cell centres, so that cells
    /// are looked up at their exact positions. Otherwise the map is stretched over the grid.
    bool texelsOnCells = true;
    /// For surfaces seen from an eye: higher resolution near the eye (Martin and Tan 2004).
    bool warp = true;
};

/// The options of engines with depth maps: "map" and "bias".
const Fields<AccrualSettings>& accrualFields();

/// Memory of accrual maps of a grid, bytes per cell: positions of receivers, bits and masks of an interval,
/// and some 30 maps of runs alive during a year.
inline constexpr double accrualBytesPerCell = 160;

/// Error that states the range of the first setting out of range.
Result<void> check(const AccrualSettings& settings);

/// Error that states the range if an interval has fewer than 1 or more than 64 steps: a mask has one bit per
/// step.
Result<void> checkSteps(int steps);

}  // namespace noonmark
