#pragma once

#include <cstddef>

#include "core/city/building.h"

namespace noonmark {

/// The number of triangles of meshOf(part), without making them if the outline has no holes: a simple polygon
/// of v points has v - 2 triangles; a prism has two such polygons and 2 v triangles in its walls.
std::size_t countTriangles(const Part& part);

}  // namespace noonmark
