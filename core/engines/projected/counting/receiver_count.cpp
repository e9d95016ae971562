#include "core/engines/projected/counting/receiver_count.h"

#include <algorithm>
#include <cmath>

namespace noonmark {

ReceiverCount::ReceiverCount(const Receivers& receivers)
    : columns_((receivers.grid.columns + side - 1) / side),
      rows_((receivers.grid.rows + side - 1) / side),
      sums_((std::size_t(columns_) + 1) * (std::size_t(rows_) + 1)) {
    const auto width = std::uint32_t(receivers.grid.columns);
    for (const std::uint32_t cell : receivers.cells)
        ++at(int(cell % width) / side + 1, int(cell / width) / side + 1);
    for (int row = 0; row < rows_; ++row)
        for (int column = 0; column < columns_; ++column)
            at(column + 1, row + 1) += at(column, row + 1) + at(column + 1, row) - at(column, row);
}

bool ReceiverCount::any(glm::dvec2 low, glm::dvec2 high, const RowBand& band) const {
    const double south = std::max(low.y, double(band.first)), north = std::min(high.y, double(band.end));
    if (south > north) return false;
    const auto square = [](double position, int count) {
        return int(std::clamp(position / side, 0.0, double(count)));
    };
    const int west = square(low.x, columns_), east = square(std::ceil(high.x) + side, columns_),
              first = square(south, rows_), end = square(std::ceil(north) + side, rows_);
    return at(east, end) - at(west, end) - at(east, first) + at(west, first) > 0;
}

}  // namespace noonmark
