#pragma once

#include <array>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/city/city.h"
#include "core/engines/api/tree_shade.h"
#include "core/engines/ray/ray_scene.h"
#include "core/receivers/point_receivers.h"
#include "core/sun/sun_steps.h"

namespace noonmark {

/// Sunlit minutes of many points.
struct PointMonths {
    std::vector<std::array<float, 12>> sunlitMin;  ///< by month, summed over the days; one entry a point
    double possibleMin = 0;                        ///< of all days, with the sun above the horizon
    /// Longest unbroken shadow and sun on any day, minutes; one entry a point, or empty: not counted.
    std::vector<float> longestShadowMin, longestSunMin;
    Cost cost;

    [[nodiscard]] double sunlitOf(std::size_t point) const {
        double sum = 0;
        for (const float minutes : sunlitMin[point]) sum += double(minutes);
        return sum;
    }
};

/// The same with trees, weighted by what crowns let through; unbroken times count a step as in shadow where
/// at least `shadedFrom` of the sun is taken. Their costs are empty.
struct ShadedPoints {
    std::optional<PointMonths> evergreen;  ///< every tree in leaf all year
    std::optional<PointMonths> seasonal;   ///< trees bare out of season
    double shadedFrom = TreeShade::defaultShadedFrom;
    std::size_t treesUsed = 0;  ///< trees whose shadow can reach a point
    std::string how;            ///< in words, for the report
    [[nodiscard]] const std::optional<PointMonths>& of(TreeColumns column) const {
        return column == TreeColumns::evergreen ? evergreen : seasonal;
    }
};

struct PointSweepSettings {
    bool runs = false;  ///< also count the longest unbroken shadow and sun
    /// Rays confirm unbroken times and search those that horizons leave in doubt; without, single points are
    /// off by hours where no bin sees a narrow gap or a narrow occluder.
    bool decidesRuns = true;
    std::optional<RayScene> scene;  ///< of the whole city, for the rays; none: made here, 0.2 s for Midtown
};

/// Minutes by month for many points on any surface: for each point the horizon at the middle
/// of each of 1440 azimuths, and the altitudes that overhangs hide above it; the suns of an azimuth are
/// looked up at once. The horizon is exact where it is taken, so the only error is that of the azimuth: a sun
/// is up to an eighth of a degree aside, half a minute of time in middle latitudes, and errors of both signs
/// meet. Unbroken times are counted step by step against the same horizons, and decided by rays where these
/// leave them in doubt: they are right within two steps, but for slits between two overhangs narrower than a
/// bin and gaps below meshes that count as solid. Uses all cores; cancelled() soon after a stop request.
/// Error: positions and normals differ in number.
Result<PointMonths> sweepPoints(const City& city, const SurfacePoints& points, const SunSteps& sun,
                                Progress& progress, const std::stop_token& stop,
                                const PointSweepSettings& settings = {});

/// The same by rays, against which the sweep is measured: every point at every step, with unbroken times.
/// Uses all cores. `scene`: of the whole city; none: made here.
Result<PointMonths> tracePoints(const City& city, const SurfacePoints& points, const SunSteps& sun,
                                Progress& progress, const std::stop_token& stop,
                                std::optional<RayScene> scene = {});

}  // namespace noonmark
