#include "core/city/meshes/triangle_count.h"

#include "core/city/city.h"

namespace noonmark {

// Holes may touch the outline or one another, in a corner or along an edge: each way, the count is another.
std::size_t countTriangles(const Part& part) {
    if (part.mesh) return part.mesh->triangles.size();
    const std::size_t points = part.footprint.outer.size();
    if (part.footprint.holes.empty() && points >= 3) return 2 * (points - 2) + 2 * points;
    return meshOf(part).triangles.size();
}

}  // namespace noonmark
