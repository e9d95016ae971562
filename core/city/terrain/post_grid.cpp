#include "core/city/terrain/post_grid.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <utility>

#include "core/base/stop_scope.h"

namespace noonmark {

namespace {

struct Values {
    std::vector<float> of;  // row-major
    int columns, rows;
    [[nodiscard]] float& at(int column, int row) {
        return of[std::size_t(row) * std::size_t(columns) + std::size_t(column)];
    }
    [[nodiscard]] float clampedAt(int column, int row) {
        return at(std::clamp(column, 0, columns - 1), std::clamp(row, 0, rows - 1));
    }
};

// The mean of each four cells that have values; NaN where none has.
Values halve(Values& fine) {
    Values coarse{{}, (fine.columns + 1) / 2, (fine.rows + 1) / 2};
    coarse.of.assign(std::size_t(coarse.columns) * std::size_t(coarse.rows),
                     std::numeric_limits<float>::quiet_NaN());
    for (int row = 0; row < coarse.rows; ++row)
        for (int column = 0; column < coarse.columns; ++column) {
            float sum = 0, count = 0;
            for (int r = 2 * row; r < std::min(2 * row + 2, fine.rows); ++r)
                for (int c = 2 * column; c < std::min(2 * column + 2, fine.columns); ++c)
                    if (const float value = fine.at(c, r); !std::isnan(value)) sum += value, ++count;
            if (count > 0) coarse.at(column, row) = sum / count;
        }
    return coarse;
}

// Bilinear between the four nearest cells of a grid of twice the cell size.
float readCoarse(Values& coarse, int column, int row) {
    const int c = column / 2, r = row / 2;
    const int besideC = c + (column % 2 != 0 ? 1 : -1), besideR = r + (row % 2 != 0 ? 1 : -1);
    return (9 * coarse.clampedAt(c, r) + 3 * coarse.clampedAt(besideC, r) + 3 * coarse.clampedAt(c, besideR) +
            coarse.clampedAt(besideC, besideR)) /
           16;
}

// Draws filled cells towards the mean of their neighbours (Gauss-Seidel), which takes away what the coarser
// grids left of their cells. A few rounds do, as the coarser grids were relaxed before.
void relax(Values& values, const std::vector<std::size_t>& filled) {
    constexpr int rounds = 8;
    for (int round = 0; round < rounds && !StopScope::isStopped(); ++round)
        for (const std::size_t cell : filled) {
            const int column = int(cell % std::size_t(values.columns));
            const int row = int(cell / std::size_t(values.columns));
            values.of[cell] = (values.clampedAt(column - 1, row) + values.clampedAt(column + 1, row) +
                               values.clampedAt(column, row - 1) + values.clampedAt(column, row + 1)) /
                              4;
        }
}

std::size_t fillLevel(Values& fine) {
    std::vector<std::size_t> gaps;
    for (std::size_t cell = 0; cell < fine.of.size(); ++cell)
        if (std::isnan(fine.of[cell])) gaps.push_back(cell);
    if (gaps.empty() || gaps.size() == fine.of.size()) return 0;
    if (StopScope::isStopped()) return 0;
    Values coarse = halve(fine);
    fillLevel(coarse);
    for (const std::size_t cell : gaps)
        fine.of[cell] =
            readCoarse(coarse, int(cell % std::size_t(fine.columns)), int(cell / std::size_t(fine.columns)));
    relax(fine, gaps);
    return gaps.size();
}

}  // namespace

std::size_t fillGaps(std::vector<float>& values, int columns, int rows) {
    Values all{std::move(values), columns, rows};
    const std::size_t filled = fillLevel(all);
    values = std::move(all.of);
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
