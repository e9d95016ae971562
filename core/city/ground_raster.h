#pragma once

#include <cstdint>
#include <vector>

#include "core/geo/grid.h"

namespace noonmark {

/// A picture of the ground, such as an aerial photograph: drawn for orientation, nothing is measured on it.
struct GroundRaster {
    Grid grid;
    std::vector<std::uint8_t>
        rgba;  ///< four bytes a cell, grid order; alpha not multiplied in, 0: no picture
};

}  // namespace noonmark
