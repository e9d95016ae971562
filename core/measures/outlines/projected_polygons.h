#pragma once

// The folder core/measures/outlines makes polygons of shadows. projected_polygons.h projects buildings onto
// level ground, join_shadows.h joins their polygons to the outlines of a moment, and level_outlines.h does
// both for the buildings near an area; traced_outlines.h makes outlines of traced cells, on terrain.
// shadow_fan.h puts the moments of a day into one picture, isochrones.h draws lines of equal values.

#include <glm/vec2.hpp>
#include <vector>

#include "core/city/building.h"

namespace noonmark {

/// Convex, counter-clockwise, local metres, not closed.
using ConvexPolygon = std::vector<glm::dvec2>;

/// Adds polygons that together are the shadow of a building on level ground at z = 0, except where the
/// building itself covers the ground. `perMetre`: where the shadow of a point 1 m up falls, seen from the
/// point below it. What lies below the ground casts none. O(points), and a triangulation for each concave
/// overhang.
void projectBuilding(const Building& building, glm::dvec2 perMetre, std::vector<ConvexPolygon>& to);

}  // namespace noonmark
