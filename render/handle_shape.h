#pragma once

#include "core/city/mesh.h"

namespace noonmark {

/// An arrow that points up and down, from the origin to `height` above it.
TriangleMesh doubleArrow(float height);

}  // namespace noonmark
