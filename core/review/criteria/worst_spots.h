#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <optional>
#include <span>
#include <stop_token>
#include <vector>

#include "core/base/result.h"
#include "core/city/city.h"
#include "core/engines/ray/ray_scene.h"
#include "core/engines/trees/crowns.h"
#include "core/measures/places/place_cells.h"
#include "core/measures/places/place_receivers.h"
#include "core/review/criteria/spot_runs.h"

namespace noonmark {

/// Points of a square grid around some middles.
struct PointGrid {
    double reachM = 0;    ///< at most so far west, east, south and north of a middle
    double spacingM = 0;  ///< of the grid; points are in the middle of its squares
};

/// The shadow at single points of places: between the centres of cells, and on the strips of open ground that
/// no centre lies on. Found by rays, from the same origins as those of the ray reference. Safe to use from
/// many threads. Cities must outlive it.
class PlacePoints {
public:
    /// `cities`: baseline, scenario, and, if there is a third, the bare ground whose own shadow does not
    /// count. `places` and `receivers` as of placeReceiversOnPlaces() for these cities; `planeZ`: local z of
    /// all points where they are measured on a plane, else they are on the ground. Trees that are weighed
    /// count from half of the sun on. A scene for each city, of the buildings in reach: some 0.5 s for
    /// Midtown. Error: memory, or cancelled().
    static Result<PlacePoints> over(std::span<const City* const> cities, std::span<const Place> places,
                                    const PlaceReceivers& receivers, std::optional<float> planeZ,
                                    const SunSteps& sun, const std::stop_token& stop = {});

    /// The centre of the cell that has this bit in the place's masks.
    [[nodiscard]] glm::dvec2 centreOf(std::size_t place, std::size_t cell) const;
    /// Points around the middles, each once, that lie in the place and on open ground in both cities.
    [[nodiscard]] std::vector<glm::dvec2> around(std::size_t place, std::span<const glm::dvec2> middles,
                                                 const PointGrid& grid) const;
    /// The shadow at these points on the day of `day`; bit i of the masks is points[i].
    [[nodiscard]] PlaceShadow shade(std::span<const glm::dvec2> points, const PlaceShadow& day) const;
    [[nodiscard]] double cellM() const { return receivers_->receivers.grid.cellM; }

private:
    PlacePoints() = default;
    [[nodiscard]] bool isOpen(std::size_t place, glm::dvec2 point) const;
    [[nodiscard]] glm::vec3 originAt(glm::dvec2 point) const;

    const City* ground_ = nullptr;
    std::span<const Place> places_;
    const PlaceReceivers* receivers_ = nullptr;
    std::optional<float> planeZ_;
    std::vector<std::vector<Footprint>> built_;  // by place: findBuiltGround()
    std::vector<RayScene> scenes_;               // by city
    std::vector<CrownMasks> crowns_;             // by city
};

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
/// the worst of them, down to spotDistanceCells: a cell's centre states nothing about the ground beside a
/// wall, and a shadow's edge crosses a cell in minutes. One list of points for each distance; expectPoints()
/// in all, a ray each for every step and city.
std::vector<PlaceShadow> refineWorstSpots(std::size_t place, const PlaceShadow& shadow,
                                          const PlacePoints& points, std::span<const SpotSearch> searches);
/// How many points so many searches look at on a day, on a place of so many cells. Measured on 60 places of
/// Chicago's Loop as they stand and on 36 in reach of a proposal; within a factor of two.
std::size_t expectPoints(std::size_t cells, std::size_t searches);

}  // namespace noonmark
