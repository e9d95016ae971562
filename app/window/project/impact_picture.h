#pragma once

#include "app/report/maps/shadow_measure.h"
#include "render/scene/ground_picture.h"
#include "scenarios/impact/impact.h"

namespace noonmark {

/// The change on the ground. Cells without a change by more than a thousandth of a minute stay transparent,
/// as do those that are no receivers in both, but for those that became building or ground. O(cells).
GroundPicture impactPicture(const Impact& impact, ShadowMeasure measure, double top);

/// "+12.0 min a day more shadow" or "no change", of the cell that holds a point; empty outside of the grid.
QString formatChange(const Impact& impact, glm::dvec2 point);

}  // namespace noonmark
