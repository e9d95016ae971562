#include "core/accumulate/projected/step_filler.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

#include "core/accumulate/projected/convex_fill.h"

namespace noonmark {

ReceiverCount::ReceiverCount(const Receivers& receivers)
    : columns_(receivers.grid.columns),
      rows_(receivers.grid.rows),
      sums_((receivers.grid.columns + 1ULL) * (receivers.grid.rows + 1ULL)) {
    const auto at = [&](int column, int row) -> std::uint32_t& {
        return sums_[std::size_t(row) * std::size_t(columns_ + 1) + std::size_t(column)];
    };
    for (int row = 0; row < rows_; ++row)
        for (int column = 0; column < columns_; ++column) {
            const bool here = receivers.kind[receivers.grid.index(column, row)] == CellKind::ground;
            at(column + 1, row + 1) =
                at(column, row + 1) + at(column + 1, row) - at(column, row) + std::uint32_t(here);
        }
}

bool ReceiverCount::any(glm::dvec2 low, glm::dvec2 high) const {
    const auto cell = [](double position, int count) {
        return int(std::clamp(position, 0.0, double(count)));
    };
    const int west = cell(std::floor(low.x), columns_), east = cell(std::ceil(high.x) + 1, columns_);
    const int south = cell(std::floor(low.y), rows_), north = cell(std::ceil(high.y) + 1, rows_);
    const auto at = [&](int column, int row) {
        return sums_[std::size_t(row) * std::size_t(columns_ + 1) + std::size_t(column)];
    };
    return at(east, north) - at(west, north) - at(east, south) + at(west, south) > 0;
}

StepFiller::StepFiller(const ShadowCasters& casters, const Receivers& receivers, const SunSteps& sun)
    : casters_(casters),
      sun_(sun),
      layout_(receivers.grid),
      cellM_(receivers.grid.cellM),
      receivers_(receivers),
      noReceivers_(layout_.words(), ~std::uint64_t{0}) {
    for (const std::uint32_t cell : receivers.cells) {
        const int column = int(cell % std::uint32_t(layout_.columns));
        noReceivers_[layout_.word(column, int(cell / std::uint32_t(layout_.columns)))] &=
            ~(std::uint64_t{1} << (column & 63));
    }
}

// The shadow of a point one metre up lies this far from the point below it.
glm::dvec2 StepFiller::throwCells(std::size_t step) const {
    const glm::dvec3 sun(sun_.steps[step].direction);
    return glm::dvec2(sun.x, sun.y) / (-sun.z * cellM_);
}

std::vector<std::uint32_t> StepFiller::castersInReach(std::size_t first, std::size_t end) const {
    glm::dvec2 low(1e30), high(-1e30);  // of the throws of these steps
    for (std::size_t step = first; step < end; ++step) {
        low = glm::min(low, throwCells(step));
        high = glm::max(high, throwCells(step));
    }
    std::vector<std::uint32_t> inReach;
    for (std::uint32_t i = 0; i < casters_.casters.size(); ++i) {
        const ShadowCaster& caster = casters_.casters[i];
        const double bottom = caster.bottomM, top = caster.topM;
        const glm::dvec2 west = caster.low + glm::min(low * bottom, low * top);
        const glm::dvec2 east = caster.high + glm::max(high * bottom, high * top);
        if (receivers_.any(west, east)) inReach.push_back(i);
    }
    return inReach;
}

FillCount StepFiller::fill(std::size_t first, std::size_t end, std::span<std::uint64_t> rasters) const {
    FillCount count;
    std::vector<glm::dvec2> polygon;
    const std::vector<std::uint32_t> inReach = castersInReach(first, end);
    count.outOfReach = (casters_.casters.size() - inReach.size()) * (end - first);
    for (std::size_t step = first; step < end; ++step) {
        const auto raster = rasters.subspan((step - first) * layout_.words(), layout_.words());
        std::ranges::copy(noReceivers_, raster.begin());
        const glm::dvec2 thrown = throwCells(step);
        for (const std::uint32_t index : inReach) {
            shadowOf(casters_, casters_.casters[index], thrown, polygon);
            if (polygon.empty()) continue;
            count.rows += std::uint64_t(fillConvex(polygon, layout_, raster));
            ++count.polygons;
        }
    }
    return count;
}

}  // namespace noonmark
