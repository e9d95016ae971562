#include "core/lab/inverse/lanes.h"

#include <algorithm>
#include <cmath>

namespace noonmark {

Lanes::Lanes(const Grid& grid, glm::dvec2 direction)
    : grid_(grid), alongX_(std::abs(direction.x) >= std::abs(direction.y)) {
    const double along = alongX_ ? direction.x : direction.y;
    const double across = alongX_ ? direction.y : direction.x;
    slope_ = along == 0 ? 0 : across / along;
    for (int major = 0; major < majors(); ++major) bend_.push_back(int(std::lround(slope_ * major)));
    const auto [low, high] = std::minmax({bend_.front(), bend_.back()});
    firstLane_ = -high;
    laneCount_ = minors() + high - low;
}

}  // namespace noonmark
