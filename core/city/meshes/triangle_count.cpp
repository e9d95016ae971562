#include "core/city/meshes/triangle_count.h"

#include "core/city/city.h"

namespace noonmark {

// With holes the caps must be triangulated: a hole may touch the outline or another hole in a corner or along
// an edge, which changes the count.
std::size_t countTriangles(const Part& part) {
    if (part.mesh) return part.mesh->triangles.size();
    const std::size_t points = part.footprint.outer.size();
    if (part.footprint.holes.empty() && points >= 3) return 2 * (points - 2) + 2 * points;
    return meshOf(part).triangles.size();
}

}  // namespace noonmark
