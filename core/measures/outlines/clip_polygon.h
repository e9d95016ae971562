#pragma once

#include "core/city/footprints/footprint.h"
#include "core/measures/outlines/projected_polygons.h"

namespace noonmark {

/// The part of a convex polygon in a box; empty if there is none. Points on a side of the box lie on it
/// exactly.
ConvexPolygon clipToBox(const ConvexPolygon& polygon, const Box2& box);

}  // namespace noonmark
