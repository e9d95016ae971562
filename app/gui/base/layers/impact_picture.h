#pragma once

#include "app/report/maps/shadow_measure.h"
#include "core/measures/colour_scale.h"
#include "render/scene/ground_picture.h"
#include "scenarios/impact/impact.h"

namespace noonmark {

/// The change of shadow as a picture for the ground. Transparent: cells that change by no more than a
/// thousandth of a minute, and cells that are not receivers in both cities; cells that became building or
/// ground have their own colour. O(cells).
GroundPicture impactPicture(const Impact& impact, ShadowMeasure measure, const ColourScale& scale);

/// The change in the cell that contains a point, such as "change: gross +12.0 min a day" or "no change";
/// empty outside the grid. As sun: "change: sun -12.0 min a day".
QString formatChange(const Impact& impact, glm::dvec2 point, ShownAs show = ShownAs::shadow);

}  // namespace noonmark
