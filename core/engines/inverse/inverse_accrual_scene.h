#pragma once

#include <memory>

#include "core/engines/common/interval_engine.h"
#include "core/engines/inverse/low_sun.h"
#include "core/engines/inverse/shadow_lines.h"
#include "core/engines/inverse/sources/source_finder.h"

namespace noonmark {

/// What an inverse accrual map is made of.
struct InverseAccrualParts {
    std::unique_ptr<SourceFinder> finder;  ///< over the grid of the receivers, padded by `marginCells`
    std::shared_ptr<ShadowLineDrawer> drawer;
    std::unique_ptr<IntervalScene> rays;  ///< for the steps of a low sun; null where there are none
    LowSun lowSun;
    int marginCells = 0;
    std::uint32_t buildingsUsed = 0;
};

/// Share of a block's receivers in a shadow of an interval's middle step that no line leads to: beyond it,
/// the block is drawn in halves. It is looked at where most receivers have a full list at both ends.
constexpr double mostMissedShare = 0.01;

/// `grid` with so many more cells on each side.
Grid padGrid(const Grid& grid, int cells);

/// The receivers outlive it.
std::unique_ptr<IntervalScene> makeInverseAccrualScene(InverseAccrualParts parts, const Receivers& receivers);

}  // namespace noonmark
