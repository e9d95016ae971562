#pragma once

#include <glm/vec2.hpp>
#include <string>

#include "core/study/point_study.h"

namespace noonmark {

/// Adds to `svg` the sunlit minutes of a mean day by month (rows, January first) and hour of the wall clock
/// (columns): the more, the darker. Beside each figure, in red or green, the minutes that the scenario takes
/// or gives, from half a minute on. `corner`: the upper left of the cells; labels lie outside, 40 px to the
/// left and 14 px above.
void drawSunCarpet(const PointStudy& study, glm::dvec2 corner, std::string& svg);

}  // namespace noonmark
