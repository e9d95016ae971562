#pragma once

#include "core/receivers/region.h"
#include "render/view/view_ray.h"

namespace noonmark {

/// The part of the ground plane that a camera sees, cut to the bounding box of the city; no polygon if it
/// sees none of it.
Region visibleGround(const CameraPose& pose, const ViewLens& lens, const ViewBounds& bounds);

}  // namespace noonmark
