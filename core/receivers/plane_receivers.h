#pragma once

#include "core/receivers/receivers.h"

namespace noonmark {

/// Raises all receivers to a horizontal plane, metres above the mean of the ground under them.
void raiseToPlane(Receivers& receivers, double planeM);

}  // namespace noonmark
