#pragma once

#include <stop_token>
#include <vector>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/measures/outlines/projected_polygons.h"
#include "core/measures/shadow_outlines.h"

namespace noonmark {

/// The projected polygons of one moment. They may overlap and reach beyond the area.
struct ProjectedShadowPolygons {
    std::vector<ConvexPolygon> common;    ///< of buildings that the baseline and the scenario share
    std::vector<ConvexPolygon> baseline;  ///< of those of the baseline alone
    std::vector<ConvexPolygon> scenario;  ///< of those of the scenario alone
};

/// Joins them to outlines, cut at the edges of `area`, without the ground in `cover`. Works in tiles on all
/// cores. Error: the polygons cannot be joined even on a grid of 1 mm, or cancelled(). Backend:
/// join_shadows_geos.cpp.
Result<ShadowOutlines> joinShadows(const ProjectedShadowPolygons& polygons,
                                   const std::vector<Footprint>& cover, const Box2& area, Progress& progress,
                                   const std::stop_token& stop);

}  // namespace noonmark
