#pragma once

#include <memory>

#include "core/engines/common/interval_engine.h"
#include "core/engines/inverse/shadow_lines.h"
#include "core/engines/inverse/sources/source_finder.h"

namespace noonmark {

/// Steps [first, end) of an interval.
struct StepRange {
    int first = 0;
    int end = 0;
    [[nodiscard]] bool empty() const { return first >= end; }
};

/// Those steps as an interval of their own; `part` must not be empty.
SunInterval cutInterval(const SunInterval& interval, StepRange part);

/// Distinguishes sun positions below a limit of altitude.
class LowSun {
public:
    explicit LowSun(double limitDeg);

    [[nodiscard]] bool is(glm::vec3 towardsSun) const { return towardsSun.z < limitZ_; }

    /// The steps with the sun at or above the limit. They are contiguous, because the sun's altitude has a
    /// single maximum on its path.
    [[nodiscard]] StepRange stepsAbove(const SunInterval& interval) const;

    /// The directions below the limit, or those that are not.
    [[nodiscard]] SunSteps of(const SunSteps& directions, bool low) const;

private:
    float limitZ_;
};

/// The parts of an inverse accrual map.
struct InverseAccrualParts {
    std::unique_ptr<SourceFinder> finder;  ///< for the grid of the receivers, padded by `marginCells`
    std::shared_ptr<ShadowLineDrawer> drawer;
    std::unique_ptr<IntervalScene> rays;  ///< for steps with a low sun; null if there are none
    LowSun lowSun;
    int marginCells = 0;
    std::uint32_t buildingsUsed = 0;
};

/// Limit for the share of a block's receivers that are in shadow at an interval's middle step although no
/// line reaches them. If it is exceeded, the block is drawn in two halves. Only checked if most receivers
/// have a full list at both ends.
constexpr double maxMissedShare = 0.01;

/// `grid` extended by this many cells on each side.
Grid padGrid(const Grid& grid, int cells);

/// The receivers must outlive the scene.
std::unique_ptr<IntervalScene> makeInverseAccrualScene(InverseAccrualParts parts, const Receivers& receivers);

}  // namespace noonmark
