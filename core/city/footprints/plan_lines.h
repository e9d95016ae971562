#pragma once

#include <glm/vec2.hpp>
#include <vector>

#include "core/city/footprints/footprint.h"

namespace noonmark {

/// A straight line in plan, local metres.
struct PlanLine {
    glm::dvec2 a, b;
};

/// The areas that lines enclose, as disjoint polygons. A ring inside a ring is a hole (a courtyard), a ring
/// inside that encloses an area again, and so on. Ends within 1 mm of each other are joined. O(n log n).
/// Backend of this whole file: plan_lines_geos.cpp.
std::vector<Footprint> findEnclosedFaces(const std::vector<PlanLine>& lines);

/// All faces bounded by lines, side by side, also those inside a hole.
std::vector<Footprint> findFaces(const std::vector<PlanLine>& lines);

/// The lines, plus a line that joins the two ends of each chain that is not closed.
std::vector<PlanLine> closeChains(const std::vector<PlanLine>& lines);

/// A point strictly inside a polygon.
glm::dvec2 findPointInside(const Footprint& polygon);

}  // namespace noonmark
