#pragma once

#include <glm/vec2.hpp>
#include <span>
#include <vector>

#include "core/geo/grid.h"

namespace noonmark {

/// A line along which a field has one value, local metres.
struct Isochrone {
    double level = 0;  ///< minutes, or the unit of the values
    /// The first point is not repeated in a closed line.
    std::vector<glm::vec2> points;
    /// A ring: shadow of this length all inside or all outside it. An open line ends at the grid's edge or at
    /// cells without a value.
    bool closed = false;
};

/// Lines of equal values: between the centres of the grid's cells values are interpolated, so a line is exact
/// to a cell. Islands and holes are rings of their own. `values`: one a cell in grid order (row 0 south), NaN
/// where there is none; where a value equals a level, the line passes just below it. In the order of the
/// levels. O(cells x levels). Empty where memory runs out or `values` has another size. Backend:
/// isochrones_gdal.cpp.
std::vector<Isochrone> traceIsochrones(const Grid& grid, std::span<const float> values,
                                       std::span<const double> levels);

}  // namespace noonmark
