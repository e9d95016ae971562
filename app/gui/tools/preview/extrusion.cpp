#include "app/gui/tools/preview/extrusion.h"

#include <algorithm>
#include <cmath>

#include "core/city/plausible_heights.h"

namespace noonmark {

namespace {

constexpr double minSine = 0.1392;  // sine of 8 degrees

}  // namespace

// The nearest points of the two lines, origin + s direction and foot + h z: their difference is perpendicular
// to both.
std::optional<double> heightOnVertical(const ViewRay& ray, glm::dvec3 foot) {
    const glm::dvec2 along(ray.direction);
    const double level2 = along.x * along.x + along.y * along.y;  // squared sine of the angle to the vertical
    if (level2 < minSine * minSine) return std::nullopt;
    const glm::dvec3 away = foot - ray.origin;
    const double distance = (along.x * away.x + along.y * away.y) / level2;
    if (!(distance > 0)) return std::nullopt;
    return ray.origin.z + distance * ray.direction.z - foot.z;
}

double wholeStoreys(double heightM, double storeyM) {
    const double most = std::floor(tallestBuildingM / storeyM + 1e-9);
    return std::clamp(std::round(heightM / storeyM), 1.0, most) * storeyM;
}

double freeHeight(double heightM, double storeyM) {
    return std::clamp(std::round(heightM * 10) / 10, storeyM, tallestBuildingM);
}

}  // namespace noonmark
