#pragma once

#include "core/city/footprints/footprint.h"
#include "core/geo/grid.h"

namespace noonmark {

/// Whether a box intersects the cells of a grid, edges included.
inline bool overlaps(const Box2& box, const Grid& grid) {
    return !box.empty() && double(box.low.x) <= grid.eastM() && double(box.high.x) >= grid.westM &&
           double(box.low.y) <= grid.northM() && double(box.high.y) >= grid.southM;
}

}  // namespace noonmark
