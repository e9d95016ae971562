#pragma once

#include "app/report/maps/legend_painter.h"
#include "render/scene/surface_picture.h"
#include "render/view/explored_view.h"

namespace noonmark {

Legend makeLegend(const ExploredView& view, ShadowMeasure measure);

/// Whether it tells of a part of the period only.
bool isSoFar(const ExploredView& view);

/// `top` minutes have the last colour of the palette. O(samples).
SurfacePicture surfacePicture(const ExploredView& view, ShadowMeasure measure, double top);

/// Level of detail and days in words: "12 of 365 days; a sample every 4 pixels, 1.2 m". `distanceM`: of what
/// is looked at.
QString describeDetail(const ExploredView& view, double distanceM);

}  // namespace noonmark
