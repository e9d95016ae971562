#include "core/city/terrain/terrain.h"

#include <algorithm>
#include <cmath>

namespace noonmark {

namespace {

// Position among posts: `post` is the lower neighbour, `share` the fraction of the way to the next.
struct Between {
    int post;
    double share;
};

Between between(double inside, int count) {
    const int post = std::min(int(inside), std::max(0, count - 2));
    return {post, inside - post};
}

// Position of a point in a cell: whether it is in the triangle below the diagonal, (0, 0) (1, 0) (1, 1), or
// above it; and its coordinates from the first corner along that triangle's first and second side.
struct InCell {
    bool lower;
    double firstSide, secondSide;
};

InCell inSquare(glm::dvec2 shares) {
    const auto [nearer, farther] = std::minmax(shares.x, shares.y);
    return {shares.x >= shares.y, farther, nearer};
}

// The triangles of a bent grid still have straight sides.
InCell inTriangle(const PostGrid& grid, glm::dvec2 place, int column, int row, bool lower) {
    const glm::dvec2 from = grid.centre(column, row), diagonal = grid.centre(column + 1, row + 1) - from;
    const glm::dvec2 side = (lower ? grid.centre(column + 1, row) : grid.centre(column, row + 1)) - from;
    const glm::dvec2 way = place - from;
    const auto cross = [](glm::dvec2 a, glm::dvec2 b) { return a.x * b.y - a.y * b.x; };
    const double area = cross(side, diagonal), alongDiagonal = cross(side, way) / area;
    return {lower, alongDiagonal + cross(way, diagonal) / area, alongDiagonal};
}

}  // namespace

float elevationAt(const Terrain& terrain, glm::dvec2 point) {
    const PostGrid& grid = terrain.grid;
    const glm::dvec2 inside = grid.insideOf(grid.columnRowOf(point));
    const auto [column, columnShare] = between(inside.x, grid.columns);
    const auto [row, rowShare] = between(inside.y, grid.rows);
    const int next = std::min(column + 1, grid.columns - 1), north = std::min(row + 1, grid.rows - 1);
    InCell in = inSquare({columnShare, rowShare});
    if (grid.isBent() && next > column && north > row)
        in = inTriangle(grid, grid.centre(inside.x, inside.y), column, row, in.lower);
    const auto at = [&](int c, int r) { return double(terrain.elevationM[grid.index(c, r)]); };
    const double low = at(column, row), high = at(next, north);
    const double side = in.lower ? at(next, row) : at(column, north);
    return float(low + in.firstSide * (side - low) + in.secondSide * (high - side));
}

TriangleMesh meshOf(const Terrain& terrain) {
    const PostGrid& grid = terrain.grid;
    TriangleMesh mesh;
    mesh.vertices.reserve(grid.size());
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
