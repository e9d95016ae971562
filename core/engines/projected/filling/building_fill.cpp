#include "core/engines/projected/filling/building_fill.h"

#include <cmath>
#include <glm/common.hpp>

namespace noonmark {

WordBox WordBox::with(const WordBox& other) const {
    if (empty()) return other;
    if (other.empty()) return *this;
    return {std::min(west, other.west), std::max(east, other.east), std::min(south, other.south),
            std::max(north, other.north)};
}

BuildingFill::BuildingFill(const BuildingCasters& buildings, const BitLayout& layout, const RowBand& band,
                           const StepOffsets& period)
    : buildings_(buildings),
      layout_(layout),
      band_(band),
      caster_(buildings.casters()),
      raster_(layout.words(), StepWords{}) {
    for (std::size_t i = 0; i < buildings.buildings(); ++i)
        reaches_.push_back(!computeBox(i, period).empty());
}

WordBox BuildingFill::computeBox(std::size_t building, const StepOffsets& throws) const {
    glm::dvec2 low(1e30), high(-1e30);
    for (const std::uint32_t i : buildings_.of(building)) {
        const SweptBox box = computeSweptBox(buildings_.casters().casters[i], throws);
        low = glm::min(low, box.low);
        high = glm::max(high, box.high);
    }
    const auto down = [](double at, int least, int most) {
        return int(std::floor(std::clamp(at, double(least), double(most))));
    };
    const int west = down(low.x, 0, layout_.columns), east = down(high.x + 1, 0, layout_.columns);
    return {west >> 6, (east + 63) >> 6, down(low.y, band_.first, band_.end) - band_.first,
            down(high.y + 1, band_.first, band_.end) - band_.first};
}

WordBox BuildingFill::fill(std::size_t building, const StepOffsets& throws) {
    if (!reaches(building)) return {};
    const WordBox box = computeBox(building, throws);
    if (box.empty()) return {};
    const std::span words(raster_.data()->words, raster_.size() * stepsTogether);
    caster_.fill(buildings_.of(building), throws, layout_, band_, words);
    return box;
}

void BuildingFill::clear(const WordBox& box) {
    for (int column = box.west; column < box.east; ++column) {
        StepWords* words = &raster_[std::size_t(column) * std::size_t(layout_.rows)];
        std::fill(words + box.south, words + box.north, StepWords{});
    }
}

}  // namespace noonmark
