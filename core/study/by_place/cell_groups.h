#pragma once

#include <cstdint>
#include <span>
#include <stop_token>
#include <vector>

#include "core/measures/places/place_receivers.h"
#include "core/study/by_place/sun_by_place.h"

namespace noonmark {

/// A cell of a place: its index in the grid, its place in Receivers::cells, and how much of it counts.
struct CountedCell {
    std::uint32_t cell = 0;
    std::uint32_t receiver = 0;
    double share = 1;
    bool isInside = true;  ///< its centre lies in the place
};

/// Places that share a grid.
struct CellGroup {
    std::vector<std::size_t> places;  ///< indices
    PlaceReceivers on;
    std::vector<std::vector<CountedCell>> cells;  ///< of each of them
};

/// All places on the cells of the study, and the small ones once more, on finer cells.
struct PlaceCells {
    CellGroup all;
    std::vector<CellGroup> small;  ///< those in one square together, without places that have no cell
};

/// Places the cells of all places on ground that is open in all cities, of which the first is the baseline.
/// Errors of placeReceiversOnPlaces(); cancelled().
Result<PlaceCells> placeCells(std::span<const City* const> cities, const std::vector<Place>& places,
                              const SunByPlaceSettings& settings, const std::stop_token& stop);

}  // namespace noonmark
