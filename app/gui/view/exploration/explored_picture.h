#pragma once

#include "app/report/maps/legend_painter.h"
#include "render/scene/surface_layer.h"
#include "render/view/explored_view.h"

namespace noonmark {

Legend makeLegend(const ExploredView& view, ShadowMeasure measure, const LegendChoice& choice = {});

/// Whether the view covers only a part of the period so far.
bool isSoFar(const ExploredView& view);

/// `top` minutes get the last colour of the palette. O(samples).
SurfacePicture surfacePicture(const ExploredView& view, ShadowMeasure measure, double top);

/// Describes level of detail and days: "12 of 365 days; a sample every 4 pixels, 1.2 m". `distanceM`:
/// distance to the view's target.
QString describeDetail(const ExploredView& view, double distanceM);

}  // namespace noonmark
