#include "core/engines/common/reached_receivers.h"

#include <algorithm>
#include <cmath>

namespace noonmark {

namespace {

constexpr int side = 32;

Box2 computeBox(const Grid& grid, int column, int row) {
    const auto along = [&](double fromM, int cells) { return float(fromM + cells * grid.cellM); };
    return {{along(grid.westM, column), along(grid.southM, row)},
            {along(grid.westM, std::min(column + side, grid.columns)),
             along(grid.southM, std::min(row + side, grid.rows))}};
}

void leaveOut(Receivers& receivers, int firstColumn, int firstRow) {
    const Grid& grid = receivers.grid;
    for (int row = firstRow; row < std::min(firstRow + side, grid.rows); ++row)
        for (int column = firstColumn; column < std::min(firstColumn + side, grid.columns); ++column)
            receivers.kind[grid.index(column, row)] = CellKind::outside;
}

}  // namespace

Receivers findReached(const Buildings& buildings, const Receivers& receivers, const ShadowReach& reach) {
    Receivers reached = receivers;
    const double groundM = lowestGroundM(receivers);
    const auto touchedByAny = [&](const Box2& tile) {
        return std::ranges::any_of(buildings, [&](const auto& building) {
            return reach.touches(bounds(*building), double(topM(*building)) - groundM, tile);
        });
    };
    for (int row = 0; row < receivers.grid.rows; row += side)
        for (int column = 0; column < receivers.grid.columns; column += side)
            if (!touchedByAny(computeBox(receivers.grid, column, row))) leaveOut(reached, column, row);
    std::erase_if(reached.cells, [&](std::uint32_t cell) { return reached.kind[cell] == CellKind::outside; });
    return reached;
}

void fillUnreached(ShadowField& without, const ShadowField& with, const Receivers& receivers) {
    for (const std::uint32_t cell : receivers.cells) {
        if (!std::isnan(without.grossMin[cell])) continue;
        without.grossMin[cell] = with.grossMin[cell];
        without.continuousMin[cell] = with.continuousMin[cell];
    }
}

}  // namespace noonmark
