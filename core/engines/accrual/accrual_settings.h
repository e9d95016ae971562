#pragma once

#include "core/base/result.h"

namespace noonmark {

/// Which faces of a closed solid a depth map holds.
enum class CasterSide {
    /// What the sun sees, as in the paper: surfaces in the sun lie on their own faces, and need a bias.
    towardsSun,
    /// What the sun does not see. Whatever lies outside of all solids has the same shadow, half the faces do,
    /// and no surface in the sun is near the faces that it is compared with.
    awayFromSun,
};

/// Of shadow accrual maps and of single shadow maps.
struct AccrualSettings {
    static constexpr int minMapSize = 16;
    static constexpr int maxMapSize = 8192;  ///< on the processor; a graphics device may allow less
    static constexpr float maxBiasM = 10;
    static constexpr float maxSlopeBias = 16;

    /// Texels a side, 16 to 8192. Source of the default: paper, section 7.2.
    int mapSize = 1024;
    /// How much nearer to the sun than a receiver something must be to shade it: metres along the normal of
    /// the map's plane, 0 to 10.
    float biasM = 0.001F;
    /// More of it for surfaces that the sun grazes: texels that the bias makes good, 0 to 16. 0.5 is just
    /// enough for a plane not to shade itself.
    float slopeBias = 0;
    CasterSide side = CasterSide::awayFromSun;
    /// Ground grids no larger than the map: one texel a cell, centre on centre, so that cells are looked up
    /// where they are. Else the map is stretched over the grid.
    bool texelsOnCells = true;
    /// Surfaces seen from an eye: more texels where it is near (Martin and Tan 2004).
    bool warp = true;
};

/// Error naming the range of the first setting that is outside of it.
Result<void> check(const AccrualSettings& settings);

/// Error naming the range when an interval has less than 1 or more than 64 steps: a mask has a bit for each.
Result<void> checkSteps(int steps);

}  // namespace noonmark
