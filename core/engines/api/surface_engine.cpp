#include "core/engines/api/surface_engine.h"

#include <fmt/format.h>

#include <algorithm>

namespace noonmark {

Result<SurfaceShadow> makeBlankSurfaceShadow(const SurfacePoints& points, const SunSteps& sun) {
    if (points.positions.size() != points.normals.size())
        return failure(
            fmt::format("{} places have {} normals", points.positions.size(), points.normals.size()),
            "surface points", "Give each place the direction that its surface faces");
    SurfaceShadow shadow;
    shadow.grossMin.assign(points.size(), 0);
    shadow.continuousMin.assign(points.size(), 0);
    shadow.sunlitMinutesPerDay = sun.sunlitMinutes() / std::max(1.0, double(sun.dayCount()));
    shadow.cost.skipped["steps with the sun below the horizon"] = sun.belowHorizon;
    return shadow;
}

}  // namespace noonmark
