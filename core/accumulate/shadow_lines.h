#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

#include "core/accumulate/interval_engine.h"
#include "core/accumulate/shadow_mask.h"
#include "core/receivers/grid.h"
#include "core/result.h"

namespace noonmark {

/// What throws a shadow on each cell of a flat grid at one instant: the heights of up to `levels` occluding
/// points on the way to the sun, nearest first (paper, section 5: the slices of the inverse accrual map).
struct ShadowSources {
    int levels = 0;
    std::vector<float>
        heightM;  ///< levels x grid size, level-major, grid order; above the ground; 0 = no occluder
    std::vector<std::uint32_t> building;  ///< the same shape; the building each point belongs to
    /// Heights of neighbouring cells on one surface differ by no more than this, metres.
    float steepestM = 4;
};

/// How a shadow moves over flat ground in an interval: a point h metres up throws its shadow, at step k, at
/// its place of the start plus h x fraction[k] x shift.
struct ShadowMotion {
    glm::dvec2 shift{};  ///< metres per metre of height, from the start of the line to its end
    std::vector<double>
        fraction;  ///< one a step, 0 to 1, monotone: rising from t1 forward, falling from tn backward
};
ShadowMotion motionForward(
    const SunInterval& interval);  ///< lines that begin where the shadow lies at the first step
ShadowMotion motionBackward(
    const SunInterval& interval);  ///< lines that begin where the shadow lies at the last step

/// Draws the line of every source into the cells' masks: bit k where the shadow lies at step k. Neighbours on
/// a lane whose occluding points lie next to each other on one building are drawn as one: what they shade
/// moves as a whole, from the step at which its front reaches a cell to the one at which its end leaves it.
class ShadowLineDrawer {
public:
    virtual ~ShadowLineDrawer() = default;
    /// ORs into `masks` (grid order, grid size). Cells whose masks are full already cost little: fill those
    /// that nobody asks for.
    [[nodiscard]] virtual Result<void> draw(const Grid& grid, const ShadowSources& sources,
                                            const ShadowMotion& motion, std::span<ShadowMask> masks,
                                            std::stop_token stop) = 0;
    [[nodiscard]] virtual std::string describe() const = 0;
};

/// On the processor, one lane of cells after the other, all cores.
std::unique_ptr<ShadowLineDrawer> makeShadowLineDrawer();

/// Which steps have been passed at a place along a line, looked up by its share of the line. Shared by all
/// drawers.
class StepTable {
public:
    static constexpr int size = 4096;
    explicit StepTable(const std::vector<double>& fraction);

    /// Bits of the steps up to a share of the line, all of them beyond its end. Entry 0 stands for what lies
    /// before its beginning; then by share, `size` entries to its end and two beyond it.
    std::vector<ShadowMask> before;
};

}  // namespace noonmark
