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

/// Draws the line of every source into the cells' masks: bit k where the shadow lies at step k.
class ShadowLineDrawer {
public:
    virtual ~ShadowLineDrawer() = default;
    /// ORs into `masks` (grid order, grid size).
    [[nodiscard]] virtual Result<void> draw(const Grid& grid, const ShadowSources& sources,
                                            const ShadowMotion& motion, std::span<ShadowMask> masks,
                                            std::stop_token stop) = 0;
    [[nodiscard]] virtual std::string describe() const = 0;
};

/// On the processor, one lane of cells after the other, all cores.
std::unique_ptr<ShadowLineDrawer> makeShadowLineDrawer();

/// Which steps fall into a cell of a line, looked up by how far along the line the cell lies. Shared by all
/// drawers.
class StepTable {
public:
    static constexpr int size = 4096;
    explicit StepTable(const std::vector<double>& fraction);

    // Both by share of the line, `size` entries to its end and two beyond it; positions count steps in the
    // order along the line.
    std::vector<std::uint8_t> firstBeyond;  ///< position of the first step at or beyond the share
    std::vector<std::uint8_t> nearest;      ///< position of the step nearest to the share
    std::vector<ShadowMask> upTo;           ///< bits of the first k positions; steps + 1 entries
};

}  // namespace noonmark
