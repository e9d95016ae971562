#pragma once

#include <cstdint>
#include <span>
#include <stop_token>
#include <vector>

#include "core/base/result.h"
#include "core/city/city.h"
#include "core/engines/api/step_sets.h"
#include "core/measures/places/place_cells.h"
#include "core/receivers/place.h"
#include "core/receivers/receivers.h"

namespace noonmark {

/// Receivers [first, first + count) of Receivers::cells.
struct CellSpan {
    std::uint32_t first = 0;
    std::uint32_t count = 0;
    bool operator==(const CellSpan&) const = default;
};

/// The cells of several places, as receivers of one run: every cell that a place touches and whose centre is
/// on open ground, also just outside the place. A cell that lies in two places (a playground in a park) is
/// one receiver and counts in both.
struct PlaceReceivers {
    Receivers receivers;
    std::vector<std::vector<CellSpan>> cellsOf;  ///< one list a place, ascending; empty: no cell of its own
    /// Cells that count more or less than their area, so that the areas of a place's cells add up to its open
    /// ground; one list a place.
    std::vector<std::vector<WeightedCell>> unevenOf;
    std::vector<std::vector<NeighbourCells>> neighboursOf;  ///< one list a place

    [[nodiscard]] std::size_t cellCount(std::size_t place) const;
    /// Index in Receivers::cells of the cell that has bit `cell` in the place's own masks.
    [[nodiscard]] std::uint32_t receiverOf(std::size_t place, std::size_t cell) const;
};

/// The cells of a region that are receivers on the ground in every city, of which there is at least one;
/// water counts as ground. Errors as of placeReceiversInPart().
Result<Receivers> placeCommonReceivers(std::span<const City* const> cities, const Region& region,
                                       const Grid& grid, const std::stop_token& stop = {});

/// The cells of the places that are receivers on the ground in every city: what a building of any of them
/// covers is left out. The grid begins at multiples of blocks of 16 cells. Open ground in a cell whose centre
/// is built on counts for the cell beside it. Errors as of gridOver(), of which the grid covers all places,
/// and cancelled(). Cost: that of placing receivers for each city, plus O(cells of the places).
Result<PlaceReceivers> placeReceiversOnPlaces(std::span<const City* const> cities,
                                              std::span<const Place> places, const ReceiverSettings& settings,
                                              const std::stop_token& stop = {});

/// The masks of some receivers alone, in their order. `chosen` is overwritten; its memory is used again.
void chooseReceivers(const StepMasks& all, std::span<const CellSpan> spans, StepMasks& chosen);

}  // namespace noonmark
