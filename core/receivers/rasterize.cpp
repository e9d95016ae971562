#include "core/receivers/rasterize.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/city/footprints/footprint.h"

namespace noonmark {

namespace {

using Crossings = std::vector<double>;

double rowY(const Grid& grid, int row) { return grid.southM + (row + 0.5) * grid.cellM; }

// First cell (or row) whose centre is at or beyond a position.
int firstAtOrBeyond(double position, double start, double cellM, int count) {
    const double cell = std::ceil((position - start) / cellM - 0.5);
    return int(std::clamp(cell, 0.0, double(count)));
}

void addCrossings(const Ring& ring, double y, Crossings& crossings) {
    for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++)
        if (crossesRow(ring[j], ring[i], y)) crossings.push_back(crossingX(ring[j], ring[i], y));
}

// ceil() of a rounded quotient can be off by one; correct it by the comparison that `contains` makes:
// crossing <= centre.
int firstColumn(const Grid& grid, double x) {
    int column = firstAtOrBeyond(x, grid.westM, grid.cellM, grid.columns);
    while (column > 0 && x <= grid.centre(column - 1, 0).x) --column;
    while (column < grid.columns && x > grid.centre(column, 0).x) ++column;
    return column;
}

}  // namespace

void forEachRun(const Footprint& footprint, const Grid& grid,
                const std::function<void(int row, int firstColumn, int endColumn)>& fill) {
    if (footprint.outer.size() < 3) return;
    Box2 box = bounds(footprint.outer);
    // even-odd: holes may extend beyond the outline
    for (const Ring& hole : footprint.holes) box.add(bounds(hole));
    const int first = std::max(0, firstAtOrBeyond(box.low.y, grid.southM, grid.cellM, grid.rows) - 1);
    const int end = std::min(grid.rows, firstAtOrBeyond(box.high.y, grid.southM, grid.cellM, grid.rows) + 1);
    Crossings crossings;
    for (int row = first; row < end; ++row) {
        crossings.clear();
        addCrossings(footprint.outer, rowY(grid, row), crossings);
        for (const Ring& hole : footprint.holes) addCrossings(hole, rowY(grid, row), crossings);
        std::sort(crossings.begin(), crossings.end());
        for (std::size_t i = 0; i + 1 < crossings.size(); i += 2) {
            const int from = firstColumn(grid, crossings[i]);
            const int to = firstColumn(grid, crossings[i + 1]);
            if (from < to) fill(row, from, to);
        }
    }
}

std::vector<std::uint32_t> collectCells(const std::vector<Footprint>& footprints, const Grid& grid) {
    std::vector<std::uint32_t> cells;
    for (const Footprint& footprint : footprints)
        forEachRun(footprint, grid, [&](int row, int first, int end) {
            for (int column = first; column < end; ++column)
                cells.push_back(std::uint32_t(grid.index(column, row)));
        });
    std::ranges::sort(cells);
    cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
    return cells;
}

}  // namespace noonmark
