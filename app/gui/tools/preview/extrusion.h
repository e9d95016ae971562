#pragma once

#include <optional>

#include "render/view/view_ray.h"

namespace noonmark {

/// Height above `foot`, metres, of the point on its vertical nearest to a view ray: the height that a handle
/// on that vertical is dragged to. Nothing if the ray is within 8 degrees of the vertical or leads away from
/// it: there one pixel would cover too many metres.
std::optional<double> heightOnVertical(const ViewRay& ray, glm::dvec3 foot);

/// The nearest whole number of storeys, at least one, as a height in metres; at most 2000 m.
double wholeStoreys(double heightM, double storeyM);

/// The nearest height that a massing may have: in steps of 0.1 m, from one storey to 2000 m.
double freeHeight(double heightM, double storeyM);

}  // namespace noonmark
