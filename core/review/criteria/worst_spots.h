#pragma once

#include <span>
#include <vector>

#include "core/measures/place_points.h"
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

/// How near the worst spots are looked for: in cells.
inline constexpr double spotDistanceCells = 1.0 / 16;

/// The shadow at points around the worst cells of a place on one day, ever closer to the worst of them, down
/// to spotDistanceCells: a cell's centre tells nothing about the ground beside a wall, and a shadow's edge
/// crosses a cell in minutes. One list of points for each distance. Some 200 points for each search that
/// finds shadow; a ray each for every step and city.
std::vector<PlaceShadow> refineWorstSpots(std::size_t place, const PlaceShadow& shadow,
                                          const PlacePoints& points, std::span<const SpotSearch> searches);

}  // namespace noonmark
