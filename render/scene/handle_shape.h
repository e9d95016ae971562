#pragma once

#include "core/city/meshes/mesh.h"

namespace noonmark {

/// A vertical double arrow from the origin up to `height`.
TriangleMesh makeDoubleArrow(float height);

}  // namespace noonmark
