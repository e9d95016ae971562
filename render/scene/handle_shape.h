#pragma once

#include "core/city/meshes/mesh.h"

namespace noonmark {

/// An arrow that points up and down, from the origin to `height` above it.
TriangleMesh makeDoubleArrow(float height);

}  // namespace noonmark
