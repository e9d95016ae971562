#pragma once

#include <memory>
#include <stop_token>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/engines/common/interval_engine.h"
#include "core/engines/inverse/lanes.h"
#include "core/engines/inverse/source_runs.h"

namespace noonmark {

/// How shadows move over flat ground during an interval: at step k, the shadow of a point h metres up is
/// displaced from its start by h x fraction[k] x shift.
struct ShadowMotion {
    glm::dvec2 shift{};  ///< metres per metre of height, from the start of the line to its end
    std::vector<double>
        fraction;  ///< one per step, 0 to 1, monotone: rising forward from t1, falling backward from tn
};
ShadowMotion computeForwardMotion(
    const SunInterval& interval);  ///< lines begin at the shadow's position at the first step
ShadowMotion computeBackwardMotion(
    const SunInterval& interval);  ///< lines begin at the shadow's position at the last step

/// A lookup table for the steps that have been passed at a position along a line, indexed by the fraction of
/// the line. Used by all drawers.
class StepTable {
public:
    static constexpr int size = 4096;
    explicit StepTable(const std::vector<double>& fraction);

    /// Bits of the steps up to a fraction of the line; all steps beyond its end. Entry 0 is for positions
    /// before the start; then follow `size` entries to the end and two beyond it.
    std::vector<ShadowMask> before;
};

/// One pass over the lanes: forward from the first step, or backward from the last.
struct LinePass {
    StepTable table;
    RunRule rule;
    bool reversed = false;  ///< shadows move towards lower major positions

    /// `steepestM`: see RunRule; for the instant of the sources.
    LinePass(const Lanes& lanes, const ShadowMotion& motion, float steepestM);
};

/// Draws the line of every source into the masks of the positions: bit k is set where the shadow lies at step
/// k. Neighbours on a lane whose occluding points are adjacent on one building are drawn as one run: it moves
/// as a whole, and shades a cell from the step at which its front reaches the cell to the step at which its
/// rear leaves it.
class ShadowLineDrawer {
public:
    virtual ~ShadowLineDrawer() = default;
    /// ORs into `masks`, which has as many blocks as `sources`. May be called concurrently if blocksAtOnce()
    /// is 1.
    [[nodiscard]] virtual Result<void> draw(const LinePass& pass, const LaneSources& sources,
                                            LaneMasks& masks) = 0;
    /// How many blocks a call should have: 1 for a drawer that leaves parallelism to its callers, all of
    /// `blocks` for a separate device.
    [[nodiscard]] virtual int blocksAtOnce(int blocks) const = 0;
    [[nodiscard]] virtual std::string describe() const = 0;
};

/// Draws on the processor.
std::unique_ptr<ShadowLineDrawer> makeShadowLineDrawer();

}  // namespace noonmark
