#pragma once

#include <glm/vec2.hpp>
#include <vector>

#include "core/city/footprints/footprint.h"

namespace noonmark {

/// A straight line in plan, local metres.
struct PlanLine {
    glm::dvec2 a, b;
};

/// What lines enclose, as disjoint polygons. A ring inside a ring encloses what is outside it (a courtyard),
/// and so on. Ends within 1 mm of one another meet. O(n log n). Backend: plan_lines_geos.cpp, like all here.
std::vector<Footprint> findEnclosedFaces(const std::vector<PlanLine>& lines);

/// The faces that lines bound, side by side, without that rule.
std::vector<Footprint> findFaces(const std::vector<PlanLine>& lines);

/// The lines, and for each chain of them that does not close a line from its one end to its other.
std::vector<PlanLine> closeChains(const std::vector<PlanLine>& lines);

/// A point inside a polygon and not on its edge.
glm::dvec2 findPointInside(const Footprint& polygon);

}  // namespace noonmark
