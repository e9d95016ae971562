#pragma once

#include "core/city/meshes/mesh.h"

namespace noonmark {

/// A vertical double arrow from the origin up to `height`.
TriangleMesh makeDoubleArrow(float height);
/// A ball around the origin.
TriangleMesh makeBall(float diameter);
/// A pin with a round head that stands with its tip on the origin, `height` high.
TriangleMesh makePin(float height);

}  // namespace noonmark
