#include "core/city/terrain.h"

#include <algorithm>
#include <cmath>

namespace noonmark {

namespace {
// Position among cell centres, kept inside them; `cell` is the lower neighbour, `share` how far towards the
// next.
struct Between {
    int cell;
    double share;
};

Between between(double position, int count) {
    const double inside = std::clamp(position, 0.0, double(count - 1));
    const int cell = std::min(int(inside), std::max(0, count - 2));
    return {cell, inside - cell};
}
}  // namespace

float elevationAt(const Terrain& terrain, glm::dvec2 point) {
    const Grid& grid = terrain.grid;
    const auto [column, x] = between((point.x - grid.westM) / grid.cellM - 0.5, grid.columns);
    const auto [row, y] = between((point.y - grid.southM) / grid.cellM - 0.5, grid.rows);
    const int east = std::min(column + 1, grid.columns - 1);
    const int north = std::min(row + 1, grid.rows - 1);
    const auto at = [&](int c, int r) { return double(terrain.elevationM[grid.index(c, r)]); };
    // The cell's diagonal runs from its south-western to its north-eastern corner, as in meshOf.
    const double low = at(column, row), high = at(east, north);
    const double side = x >= y ? at(east, row) : at(column, north);
    const auto [nearer, farther] = std::minmax(x, y);
    return float(low + farther * (side - low) + nearer * (high - side));
}

TriangleMesh meshOf(const Terrain& terrain) {
    const Grid& grid = terrain.grid;
    TriangleMesh mesh;
    for (int row = 0; row < grid.rows; ++row)
        for (int column = 0; column < grid.columns; ++column)
            mesh.vertices.emplace_back(
                glm::vec3(glm::dvec3(grid.centre(column, row), terrain.elevationM[grid.index(column, row)])));
    for (int row = 0; row + 1 < grid.rows; ++row)
        for (int column = 0; column + 1 < grid.columns; ++column) {
            const auto corner = [&](int c, int r) { return std::uint32_t(grid.index(column + c, row + r)); };
            mesh.triangles.emplace_back(corner(0, 0), corner(1, 0), corner(1, 1));
            mesh.triangles.emplace_back(corner(0, 0), corner(1, 1), corner(0, 1));
        }
    return mesh;
}

}  // namespace noonmark
