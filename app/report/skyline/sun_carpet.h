#pragma once

#include <glm/vec2.hpp>
#include <string>

#include "core/study/point_study.h"

namespace noonmark {

/// Adds to `svg` the sunlit minutes of a mean day by month (rows, January first) and hour of the wall clock
/// (columns). Darker yellow is more sun; below each figure what the scenario takes or gives, in red or green,
/// from half a minute a day on. `corner`: the upper left of the cells; labels lie outside, 40 px to the left
/// and 14 px above.
void drawSunCarpet(const PointStudy& study, glm::dvec2 corner, std::string& svg);

/// The size of the cells together.
glm::dvec2 sunCarpetSizePx();

}  // namespace noonmark
