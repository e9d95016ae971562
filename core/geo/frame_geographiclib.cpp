#include <fmt/format.h>

#include <GeographicLib/LocalCartesian.hpp>
#include <cmath>
#include <glm/vec3.hpp>
#include <vector>

#include "core/geo/frame.h"

namespace noonmark {

namespace {
// Kept for the thread's next point: making one takes twice as long as a transformation.
const GeographicLib::LocalCartesian& cartesianAt(LonLat origin) {
    thread_local LonLat lastOrigin{};
    thread_local GeographicLib::LocalCartesian last(0, 0, 0);
    if (origin != lastOrigin) {
        last.Reset(origin.latDeg, origin.lonDeg, 0);
        lastOrigin = origin;
    }
    return last;
}
}  // namespace

Frame::Frame(LonLat origin, double originElevationM) : origin_(origin), originElevationM_(originElevationM) {}

glm::dvec2 Frame::localFromLonLat(LonLat place) const {
    glm::dvec2 local{};
    double up = 0;
    cartesianAt(origin_).Forward(place.latDeg, place.lonDeg, 0, local.x, local.y, up);
    return local;
}

LonLat Frame::lonLatFromLocal(glm::dvec2 local) const {
    // The point of the ellipsoid under (x, y) lies below the tangent plane; iterate to find how far.
    constexpr double radiusM = 6371000;
    const auto& cartesian = cartesianAt(origin_);
    double up = -(local.x * local.x + local.y * local.y) / (2 * radiusM);
    LonLat place{};
    for (int i = 0; i < 8; ++i) {
        double height = 0;
        cartesian.Reverse(local.x, local.y, up, place.latDeg, place.lonDeg, height);
        if (std::abs(height) < 1e-6) break;
        up -= height;
    }
    return place;
}

glm::dmat2 Frame::localFromEastNorth(LonLat place) const {
    glm::dvec3 local{};
    std::vector<double> axes(9);  // axes of the place in those of the origin, row by row
    cartesianAt(origin_).Forward(place.latDeg, place.lonDeg, 0, local.x, local.y, local.z, axes);
    return {axes[0], axes[3], axes[1], axes[4]};  // column-major
}

std::string Frame::projString() const {
    return fmt::format(
        "+proj=ortho +lat_0={:.10f} +lon_0={:.10f} +x_0=0 +y_0=0 +datum=WGS84 +units=m +no_defs",
        origin_.latDeg, origin_.lonDeg);
}

}  // namespace noonmark
