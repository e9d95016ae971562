#pragma once

#include <stop_token>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/city/city.h"
#include "core/engines/api/shadow_field.h"
#include "core/receivers/point_receivers.h"
#include "core/sun/sun_steps.h"

namespace noonmark {

struct StepMemory;  // core/engines/graph/interval_tally.h

/// Shadow on surface points for one period: what ShadowField is for a grid.
struct SurfaceShadow {
    std::vector<float> grossMin;  ///< minutes in shadow per day, mean over the period's days; one per point
    std::vector<float> continuousMin;  ///< longest unbroken run on any day, minutes; one per point
    double sunlitMinutesPerDay = 0;    ///< mean minutes per day with the sun above the horizon

    std::string engine;  ///< name and settings in words
    Cost cost;
};

/// An engine for receivers on arbitrary surfaces. A surface that faces away from the sun, or is edge-on to
/// it, is in its own shadow. Const and stateless across calls; uses all cores; reports progress, and returns
/// cancelled() within 0.2 s of a stop request. Error: positions and normals differ in number.
class SurfaceEngine {
public:
    virtual ~SurfaceEngine() = default;
    [[nodiscard]] virtual Result<SurfaceShadow> accumulate(const City& city, const SurfacePoints& points,
                                                           const SunSteps& sun, Progress& progress,
                                                           std::stop_token stop) const = 0;

    /// The same result. Engines that process a day in intervals, like the accrual maps, store its steps in
    /// `memory` and base running results on the steps of a coarser view (interval_tally.h).
    [[nodiscard]] virtual Result<SurfaceShadow> accumulate(const City& city, const SurfacePoints& points,
                                                           const SunSteps& sun, Progress& progress,
                                                           std::stop_token stop,
                                                           const StepMemory& /*memory*/) const {
        return accumulate(city, points, sun, progress, std::move(stop));
    }
};

/// A result with 0 minutes and the period's figures, from which every surface engine starts. Error: positions
/// and normals differ in number.
Result<SurfaceShadow> makeBlankSurfaceShadow(const SurfacePoints& points, const SunSteps& sun);

}  // namespace noonmark
