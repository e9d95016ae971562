#pragma once

#include <memory>

#include "core/engines/common/interval_engine.h"
#include "core/engines/inverse/low_sun.h"
#include "core/engines/inverse/shadow_lines.h"
#include "core/engines/inverse/sources/source_finder.h"

namespace noonmark {

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
