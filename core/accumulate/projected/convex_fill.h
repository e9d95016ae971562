#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <span>
#include <vector>

#include "core/accumulate/projected/bit_raster.h"

namespace noonmark {

/// Fills convex polygons into a bit raster. Works in cells: the centre of cell (column, row) is at (column,
/// row), so that a polygon is filled by the same half-open rule as everywhere (core/city/crossing.h). Holds
/// scratch rows; one a thread.
class ConvexFill {
public:
    explicit ConvexFill(const BitLayout& layout);

    /// `polygon`: counter-clockwise, convex, at least 3 points, in cells; what lies off the raster is
    /// clipped. Returns the number of rows filled. Cost: some nanoseconds a row.
    int fill(std::span<const glm::dvec2> polygon, std::span<std::uint64_t> raster);

private:
    BitLayout layout_;
    std::vector<std::int32_t> left_;   // by row: first column inside
    std::vector<std::int32_t> right_;  // by row: first column beyond
};

}  // namespace noonmark
