#include "core/city/terrain/fill_gaps.h"

#include <cmath>

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

}  // namespace noonmark
