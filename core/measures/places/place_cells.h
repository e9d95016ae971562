#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/city/city.h"
#include "core/engines/api/step_sets.h"
#include "core/geo/grid.h"
#include "core/receivers/place.h"
#include "core/sun/sun_steps.h"

namespace noonmark {

/// A cell of which more or less than its own area counts: it lies on the edge of the place or of a building,
/// or also stands for the open ground beside it whose own cell has its centre in a building.
struct WeightedCell {
    std::uint32_t bit = 0;  ///< of the place's masks
    double extra = 0;       ///< cells that count besides its own; -1 to 8
    /// Its centre is beside the place: it counts for areas and shares, not for spots and times. Never of all
    /// cells of a place.
    bool isBeside = false;
};

/// Cells [first, first + count) of which each has its eastern or northern neighbour in [second, second +
/// count), as bits of the place's masks.
struct NeighbourCells {
    std::uint32_t first = 0, second = 0, count = 0;
};

/// Shadow on the cells of one place over one day, in the baseline and in the scenario. The cells are those
/// that are receivers in both; cells that a building of either covers are left out. Bit c of both masks is
/// the same cell; its centre decides, and its share of the place weighs it. Days with no step above the
/// horizon have no steps.
///
/// Each step counts `stepMinutes` and has the sun of its beginning. A gap between the slots of two steps
/// (SunStep::slot) ends an unbroken run.
struct PlaceShadow {
    CivilDate day;
    std::span<const SunStep> steps;  ///< of the day; belongs to the period's SunSteps
    double cellAreaM2 = 1;
    double stepMinutes = 1;
    StepMasks baseline;                      ///< masks over the place's own cells only
    StepMasks scenario;                      ///< as large; equal to `baseline` where no scenario is given
    std::span<const WeightedCell> uneven{};  ///< ascending; all others count once
    std::span<const NeighbourCells> neighbours{};  ///< all pairs; none: the edges of shadows are not known

    [[nodiscard]] double areaM2() const {
        double cells = double(baseline.receivers);
        for (const WeightedCell& cell : uneven) cells += cell.extra;
        return cells * cellAreaM2;
    }
};

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
