#pragma once

#include <optional>

#include "render/view/view_ray.h"

namespace noonmark {

/// Height above `foot` of the point on its vertical that a ray of the view passes nearest to, metres; what a
/// handle on that vertical is dragged to. None where the ray runs within 8 degrees of the vertical, or away
/// from it: there a pixel would be worth too many metres.
std::optional<double> heightOnVertical(const ViewRay& ray, glm::dvec3 foot);

/// The nearest whole number of storeys, one at least, as a height in metres; never above 2000 m.
double wholeStoreys(double heightM, double storeyM);

/// A height that a massing may have: 0.1 m steps, one storey to 2000 m.
double freeHeight(double heightM, double storeyM);

}  // namespace noonmark
