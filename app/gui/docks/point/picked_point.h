#pragma once

#include "core/study/point_study.h"
#include "render/view/scene_picker.h"

namespace noonmark {

/// The question about the surface under the cursor: the ground, a roof (taken as level) or, facing its
/// azimuth, a wall. The day, the clock and the step are left as they are.
PointQuestion questionAt(const City& city, const Pick& pick);

}  // namespace noonmark
