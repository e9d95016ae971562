#pragma once

#include "core/city/city.h"
#include "core/receivers/region.h"
#include "render/outline_geometry.h"

namespace noonmark {

/// The outline of a region as lines that follow the ground, a little above it.
std::vector<GroundLine> groundLinesOf(const Region& region, const City& city);

/// A line through points on the ground, open while it is being drawn.
GroundLine groundLineOf(const std::vector<glm::vec3>& points, const City& city, bool closed);

}  // namespace noonmark
