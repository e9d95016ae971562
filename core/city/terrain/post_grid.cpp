#include "core/city/terrain/post_grid.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace noonmark {

std::size_t fillFromNearest(std::vector<float>& values, int columns, int rows) {
    // Breadth-first search that starts from all known cells next to a gap; each filled cell enters the queue
    // once.
    std::vector<std::size_t> wave;
    const auto index = [&](int column, int row) {
        return std::size_t(row) * std::size_t(columns) + std::size_t(column);
    };
    const auto forEachEmptyNeighbour = [&](std::size_t cell, auto&& visit) {
        const int column = int(cell % std::size_t(columns));
        const int row = int(cell / std::size_t(columns));
        for (int r = std::max(0, row - 1); r <= std::min(rows - 1, row + 1); ++r)
            for (int c = std::max(0, column - 1); c <= std::min(columns - 1, column + 1); ++c)
                if (std::isnan(values[index(c, r)])) visit(index(c, r));
    };
    for (std::size_t cell = 0; cell < values.size(); ++cell) {
        if (std::isnan(values[cell])) continue;
        bool onRim = false;
        forEachEmptyNeighbour(cell, [&](std::size_t) { onRim = true; });
        if (onRim) wave.push_back(cell);
    }
    std::size_t filled = 0;
    for (std::vector<std::size_t> next; !wave.empty(); wave.swap(next), next.clear())
        for (const std::size_t cell : wave)
            forEachEmptyNeighbour(cell, [&](std::size_t neighbour) {
                values[neighbour] = values[cell];
                next.push_back(neighbour);
                ++filled;
            });
    return filled;
}

namespace {

// A position in the variables of the bend.
struct BendPlace {
    double u, v;
    double perColumn, perRow;  // derivatives of u and v
    BendPlace(const PostGrid& posts, glm::dvec2 at)
        : perColumn(2.0 / std::max(1, posts.columns - 1)), perRow(2.0 / std::max(1, posts.rows - 1)) {
        u = at.x * perColumn - 1;
        v = at.y * perRow - 1;
    }
};

glm::dvec2 bentBy(const PostGrid& posts, const BendPlace& at) {
    const auto& [uu, uv, vv, uuu, uuv, uvv, vvv] = posts.bend;
    const double u = at.u, v = at.v;
    return u * u * (uu + u * uuu + v * uuv) + v * v * (vv + v * vvv + u * uvv) + u * v * uv;
}

double cross(glm::dvec2 a, glm::dvec2 b) { return a.x * b.y - a.y * b.x; }

// Expresses the vector `way` in column and row steps.
glm::dvec2 inSteps(const PostGrid::Steps& steps, glm::dvec2 way) {
    return glm::dvec2(cross(way, steps.row), cross(steps.column, way)) / cross(steps.column, steps.row);
}

}  // namespace

PostGrid::PostGrid(const Grid& grid)
    : columns(grid.columns),
      rows(grid.rows),
      cellM(grid.cellM),
      first(grid.centre(0, 0)),
      columnStep(grid.cellM, 0),
      rowStep(0, grid.cellM) {}

glm::dvec2 PostGrid::centre(double column, double row) const {
    const glm::dvec2 place = first + column * columnStep + row * rowStep;
    return isBent() ? place + bentBy(*this, {*this, {column, row}}) : place;
}

PostGrid::Steps PostGrid::stepsAt(glm::dvec2 columnRow) const {
    if (!isBent()) return {columnStep, rowStep};
    const BendPlace at(*this, columnRow);
    const auto& [uu, uv, vv, uuu, uuv, uvv, vvv] = bend;
    const double u = at.u, v = at.v;
    return {columnStep + at.perColumn * (u * (2.0 * uu + 3 * u * uuu + 2 * v * uuv) + v * (uv + v * uvv)),
            rowStep + at.perRow * (v * (2.0 * vv + 3 * v * vvv + 2 * u * uvv) + u * (uv + u * uuv))};
}

glm::dvec2 PostGrid::columnRowOf(glm::dvec2 point) const {
    glm::dvec2 found = inSteps({columnStep, rowStep}, point - first);
    if (!isBent()) return found;
    // Newton's method; since the bend is small, the error converges quadratically.
    const glm::dvec2 size(columns, rows);
    constexpr int maxRounds = 6;
    for (int round = 0; round < maxRounds; ++round) {
        found = glm::clamp(found, -0.5 * size, 1.5 * size);
        const glm::dvec2 off = inSteps(stepsAt(found), point - centre(found.x, found.y));
        found += off;
        if (std::max(std::abs(off.x), std::abs(off.y)) < 1e-6) break;
    }
    return found;
}

glm::dvec2 PostGrid::insideOf(glm::dvec2 columnRow) const {
    return glm::clamp(columnRow, glm::dvec2(0), glm::dvec2(columns - 1, rows - 1));
}

Box2 bounds(const PostGrid& posts) {
    Box2 box;
    for (int column = 0; column < posts.columns; ++column)
        for (const int row : {0, posts.rows - 1}) box.add(glm::vec2(posts.centre(column, row)));
    for (int row = 0; row < posts.rows; ++row)
        for (const int column : {0, posts.columns - 1}) box.add(glm::vec2(posts.centre(column, row)));
    return box;
}

double beyondM(const PostGrid& posts, glm::dvec2 point) {
    const glm::dvec2 at = posts.columnRowOf(point), inside = posts.insideOf(at);
    const glm::dvec2 out = glm::abs(at - inside);
    if (std::max(out.x, out.y) <= 0.5) return 0;
    return glm::distance(point, posts.centre(inside.x, inside.y));
}

}  // namespace noonmark
