#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/city/city.h"
#include "core/geo/grid.h"
#include "core/receivers/place.h"

namespace noonmark {

/// How much of a cell lies in a place, on open ground.
struct CellPart {
    std::uint32_t cell = 0;  ///< index in the grid
    double share = 1;        ///< above 0, at most 1
};

/// Where buildings of any of the cities touch the ground in the boxes of the places: a list for each place.
std::vector<std::vector<Footprint>> findBuiltGround(std::span<const City* const> cities,
                                                    std::span<const Place> places);

/// The polygons of a place without the ground that is built on.
std::vector<Footprint> findOpenGround(const Place& place, const std::vector<Footprint>& built);

/// Every cell that the polygons touch, ascending, with the exact share of it that they cover; they do not
/// overlap each other. O(cells + cells on edges), some 10 ns each.
std::vector<CellPart> listCellParts(const std::vector<Footprint>& polygons, const Grid& grid);

}  // namespace noonmark
