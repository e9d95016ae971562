#pragma once

#include <vector>

#include "core/city/footprints/footprint.h"
#include "core/geo/grid.h"

namespace noonmark {

/// Cells of one band that touch along sides, as one polygon along their sides.
struct BandPolygon {
    int band = 0;
    Footprint outline;  ///< local metres
};

/// All cells with a band, as polygons. `bands`: of every cell in grid order (row 0 south); -1: none. Backend:
/// band_polygons_gdal.cpp. O(cells). None where there is not enough memory.
std::vector<BandPolygon> traceBands(const Grid& grid, std::vector<int> bands);

}  // namespace noonmark
