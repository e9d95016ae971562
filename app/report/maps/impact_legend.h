#pragma once

#include "app/report/maps/change_scale.h"
#include "app/report/maps/legend_painter.h"
#include "scenarios/impact/impact.h"

namespace noonmark {

/// Colours of cells that were or are no receivers: neither less nor more shadow.
namespace ground {
constexpr QColor becameBuilding{0x70, 0x72, 0x78};
constexpr QColor becameGround{0xf3, 0xd6, 0x6b};
}  // namespace ground

/// Minutes of change in grid order, NaN where there is no receiver in both cities. Belongs to `impact`.
const std::vector<float>& getValues(const Impact& impact, ShadowMeasure measure);

/// True for the difference of one moment: more shadow or less, not minutes.
bool isInstant(const Impact& impact);

/// Symmetric about no change. The unit says whether the scale is locked, and names the largest change where
/// that is beyond its ends. A scale that is not locked ends where 98 % of the cells that change lie within,
/// so that one dark corner does not make all else pale. O(cells).
Legend makeLegend(const Impact& impact, ShadowMeasure measure, const ChangeScale& scale);

/// The colour of a cell; none where there is no change by more than a thousandth of a minute, and where it is
/// no receiver in both, but for what became building or ground. `top`: the legend's.
std::optional<QColor> pickColour(const Impact& impact, ShadowMeasure measure, std::size_t cell, double top);

}  // namespace noonmark
