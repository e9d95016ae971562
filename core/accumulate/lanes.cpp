#include "core/accumulate/lanes.h"

#include <algorithm>
#include <cmath>

namespace noonmark {

Lanes::Lanes(const Grid& grid, glm::dvec2 direction)
    : grid_(grid), alongX_(std::abs(direction.x) >= std::abs(direction.y)) {
    const double along = alongX_ ? direction.x : direction.y;
    const double across = alongX_ ? direction.y : direction.x;
    const double slope = along == 0 ? 0 : across / along;
    const int majors = alongX_ ? grid.columns : grid.rows;
    const int minors = alongX_ ? grid.rows : grid.columns;
    for (int major = 0; major < majors; ++major) bend_.push_back(int(std::lround(slope * major)));
    const auto [low, high] = std::minmax({bend_.front(), bend_.back()});
    firstLane_ = -high;
    laneCount_ = minors + high - low;
}

Lanes::Stretch Lanes::stretch(int lane) const {
    const int minors = alongX_ ? grid_.rows : grid_.columns;
    const int start = lane + firstLane_;
    const auto onGrid = [&](int bend) { return start + bend >= 0 && start + bend < minors; };
    // The bend is monotone, so the cells on the grid are one stretch.
    const bool rising = bend_.back() >= bend_.front();
    const auto before = [&](int bend) { return rising ? start + bend < 0 : start + bend >= minors; };
    const auto first = std::partition_point(bend_.begin(), bend_.end(), before);
    const auto end = std::partition_point(first, bend_.end(), onGrid);
    return {int(first - bend_.begin()), int(end - bend_.begin())};
}

}  // namespace noonmark
