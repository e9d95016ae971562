#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/measures/places/place_points.h"
#include "core/review/criteria/spot_runs.h"

namespace noonmark {

/// A figure of single spots whose worst is wanted: most shadow, or least sun.
struct SpotSearch {
    Quantity quantity = Quantity::shadow;
    Measure measure = Measure::spotTotal;  ///< spotTotal, spotLongestRun or spotLongestRuns
    RunSettings runs;
    bool former = false;  ///< in the baseline
    bool operator==(const SpotSearch&) const = default;
};

/// Whether a measure is about the worst spot of a place.
bool isOfWorstSpot(Measure measure);

/// The figures of spots that a review of that rule states: those of every row, and those of its criteria.
std::vector<SpotSearch> listSpotSearches(const Rule& rule);

/// The figure of each spot, in steps.
const std::vector<std::uint32_t>& stepsOf(const SpotRuns& runs, Measure measure);

/// How bad a spot in each cell may be, in steps: its centre's figure, and on the worse side of it as much as
/// lies between that and the cells beside it. Of cells whose centre lies beside the place: no shadow, or sun
/// without end. `steps`: the figure of each cell, of a quantity of `shadow`.
std::vector<std::uint32_t> boundSpots(const PlaceShadow& shadow, Quantity quantity,
                                      const std::vector<std::uint32_t>& steps);

/// The cells that may hold a spot worse than every centre, by their bounds. A bound holds where shadow
/// changes steadily from centre to centre: a strip of shadow between centres that are all alike is not
/// suspected.
struct Suspects {
    std::vector<std::uint32_t> cells;   ///< the first of them, maxSuspects at most, worst bound first
    std::optional<std::uint32_t> next;  ///< bound of the first that is not among them; none: all are
};
Suspects listSuspects(const PlaceShadow& shadow, Quantity quantity, const std::vector<std::uint32_t>& steps);
inline constexpr std::size_t maxSuspects = 64;

/// How near the worst spots are looked for: in cells.
inline constexpr double spotDistanceCells = 1.0 / 16;

/// The shadow at points around the worst cells of a place on one day and around its Suspects, ever closer to
/// the worst of them, down to spotDistanceCells: a cell's centre tells nothing about the ground beside a
/// wall, and a shadow's edge crosses a cell in minutes. One list of points for each distance. Some
/// pointsOfASearch for each search that finds shadow; a ray each for every step and city.
std::vector<PlaceShadow> refineWorstSpots(std::size_t place, const PlaceShadow& shadow,
                                          const PlacePoints& points, std::span<const SpotSearch> searches);
inline constexpr std::size_t pointsOfASearch = 300;

}  // namespace noonmark
