#pragma once

#include "core/city/footprints/footprint.h"
#include "core/measures/outlines/projected_polygons.h"

namespace noonmark {

/// The part of a convex polygon in a box; empty if there is none. Points on a side of the box lie on it
/// exactly.
ConvexPolygon clipToBox(const ConvexPolygon& polygon, const Box2& box);

/// Leaves out the polygons that lie in another one of the list, so that fewer have to be joined. Largest
/// first. O(polygons x polygons left).
void dropContained(std::vector<ConvexPolygon>& polygons);

}  // namespace noonmark
