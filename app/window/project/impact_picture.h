#pragma once

#include "app/report/legend_painter.h"
#include "render/ground_picture.h"
#include "scenarios/impact/impact.h"

namespace noonmark {

/// Colours of cells that were or are no receivers: neither less nor more shadow.
namespace ground {
constexpr QColor becameBuilding{0x70, 0x72, 0x78};
constexpr QColor becameGround{0xf3, 0xd6, 0x6b};
}  // namespace ground

/// Minutes of change in grid order, NaN where there is no receiver in both cities. Belongs to `impact`.
const std::vector<float>& valuesOf(const Impact& impact, ShadowMeasure measure);

/// Symmetric about no change. The ends are where 98 % of the cells that change lie within, so that one dark
/// corner does not make all else pale; `unit` names the largest change where that is more. O(cells).
Legend legendOf(const Impact& impact, ShadowMeasure measure);

/// The change on the ground. Cells without a change by more than a thousandth of a minute stay transparent,
/// as do those that are no receivers in both, but for those that became building or ground. O(cells).
GroundPicture impactPicture(const Impact& impact, ShadowMeasure measure, double top);

/// "+12.0 min a day more shadow" or "no change", of the cell that holds a point; empty outside of the grid.
QString changeText(const Impact& impact, glm::dvec2 point);

}  // namespace noonmark
