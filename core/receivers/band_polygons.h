#pragma once

#include <vector>

#include "core/city/footprints/footprint.h"
#include "core/geo/grid.h"

namespace noonmark {

/// A polygon around edge-connected cells of one band, along the sides of the cells.
struct BandPolygon {
    int band = 0;
    Footprint outline;  ///< local metres
};

inline constexpr int noBand = -1;

/// Traces all cells that have a band. `bands`: one per cell in grid order (row 0 south), or `noBand`.
/// Backend: band_polygons_gdal.cpp. O(cells). Empty where memory runs out.
std::vector<BandPolygon> traceBands(const Grid& grid, std::vector<int> bands);

}  // namespace noonmark
