#pragma once

#include <cstddef>

#include "core/city/building.h"

namespace noonmark {

/// As many triangles as meshOf(part) has, without making them where the outline has no holes: a simple
/// polygon of v points has v - 2 triangles, a prism two of those and 2 v in its walls.
std::size_t countTriangles(const Part& part);

}  // namespace noonmark
