#pragma once

#include <memory>
#include <stop_token>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/engines/common/interval_engine.h"
#include "core/engines/inverse/lane_masks.h"
#include "core/engines/inverse/lane_sources.h"
#include "core/engines/inverse/lanes.h"
#include "core/engines/inverse/source_runs.h"

namespace noonmark {

/// How a shadow moves over flat ground in an interval: a point h metres up throws its shadow, at step k, at
/// its place of the start plus h x fraction[k] x shift.
struct ShadowMotion {
    glm::dvec2 shift{};  ///< metres per metre of height, from the start of the line to its end
    std::vector<double>
        fraction;  ///< one a step, 0 to 1, monotone: rising from t1 forward, falling from tn backward
};
ShadowMotion computeForwardMotion(
    const SunInterval& interval);  ///< lines that begin where the shadow lies at the first step
ShadowMotion computeBackwardMotion(
    const SunInterval& interval);  ///< lines that begin where the shadow lies at the last step

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

/// One way over the lanes: from the first step on, or from the last backward.
struct LinePass {
    StepTable table;
    RunRule rule;
    bool reversed = false;  ///< shadows move towards lower major positions

    /// `steepestM`: see RunRule; of the sources' instant.
    LinePass(const Lanes& lanes, const ShadowMotion& motion, float steepestM);
};

/// Draws the line of every source into the places' masks: bit k where the shadow lies at step k. Neighbours
/// on a lane whose occluding points lie next to each other on one building are drawn as one: what they shade
/// moves as a whole, from the step at which its front reaches a cell to the one at which its end leaves it.
class ShadowLineDrawer {
public:
    virtual ~ShadowLineDrawer() = default;
    /// ORs into `masks`, which has as many blocks as `sources`. May be called for several at a time where
    /// blocksAtOnce() is 1.
    [[nodiscard]] virtual Result<void> draw(const LinePass& pass, const LaneSources& sources,
                                            LaneMasks& masks) = 0;
    /// How many blocks a call should have: 1 for a drawer that leaves the cores to its callers, all of
    /// `blocks` for a device of its own.
    [[nodiscard]] virtual int blocksAtOnce(int blocks) const = 0;
    [[nodiscard]] virtual std::string describe() const = 0;
};

/// On the processor.
std::unique_ptr<ShadowLineDrawer> makeShadowLineDrawer();

}  // namespace noonmark
