#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "core/base/result.h"
#include "core/describe/field.h"
#include "core/lab/graph/interval_engine.h"
#include "core/sun/sun_steps.h"

namespace noonmark {

/// Divides the sky into cells between circles of declination and of hour angle. In these coordinates the sun
/// moves uniformly: along one of them during a day, along the other during a year. Both ends of an hour
/// therefore leave their bins on the same days of the year, and fewer pairs of bins occur than with azimuth
/// and altitude. Two directions of a bin are less than `boundDeg` apart.
class DirectionBins {
public:
    /// `intervalMinutes`: from the start of an interval to the start of the next; a multiple of the columns'
    /// width. The pole is derived from the steps' arcs; without arcs, bins are of azimuth and altitude.
    DirectionBins(const SunSteps& sun, double boundDeg, double intervalMinutes);

    /// Number of the bin in which the sun, now in `direction` (a unit vector), will be in `inMinutes`
    /// minutes.
    [[nodiscard]] std::uint32_t of(glm::dvec3 direction, double inMinutes = 0) const;

private:
    glm::dvec3 pole_{0, 0, 1}, noon_{0, -1, 0}, evening_{-1, 0, 0};  // orthogonal unit vectors
    double columnDeg_ = 1, ringDeg_ = 1;
};

struct DirectionGraphSettings {
    /// Directions that share a bin are at most this far apart, degrees, 0.1 to 20. Source of the default:
    /// paper, section 7.
    double boundDeg = 5;
    double intervalMinutes = 60;  ///< 0.1 to 120
    bool merge = true;  ///< false: every interval of every day is an edge of its own (no error from bins)
};

/// The options of every engine that shades one interval at a time: "interval" and "bound".
const Fields<DirectionGraphSettings>& graphFields();

/// The intervals of a period, with similar ones merged so that they are computed once (paper, section 6).
struct DirectionGraph {
    /// All intervals that lead from one bin to another, the bin where the next interval begins, in the same
    /// number of steps. `sun` runs between the mean directions of these intervals, which are closer to each
    /// of them than the bins' centres.
    struct Edge {
        SunInterval sun;
        std::uint32_t fromBin = 0;
        std::uint32_t toBin = 0;
        std::uint32_t weight = 0;  ///< number of the period's intervals on this edge
    };
    /// One interval on a day's path.
    struct Leg {
        std::uint32_t edge = 0;
        bool breaksRun = false;  ///< steps are missing before it, so runs end
    };
    /// The legs of one or more days; days with the same path are listed once.
    using Path = std::vector<Leg>;
    DirectionBins bins;
    double stepMinutes = 1;
    std::vector<Edge> edges;
    std::vector<Path> paths;      ///< ordered so that paths that share edges are close together
    std::uint64_t intervals = 0;  ///< before merging
};

/// Error that states the range if a setting is out of range. Remaining steps at the end of a window form a
/// shorter interval. O(steps).
Result<DirectionGraph> buildDirectionGraph(const SunSteps& sun, const DirectionGraphSettings& settings);

}  // namespace noonmark
