#pragma once

#include <cmath>
#include <glm/vec2.hpp>
#include <numbers>

namespace noonmark {

/// Where a direction of the sky lies on a drawing, y down. Azimuths are from true north, clockwise, degrees;
/// altitudes 0 to 90.
struct SkyFrame {
    enum class Kind { cylindrical, stereographic };
    Kind kind = Kind::cylindrical;
    glm::dvec2 corner{};  ///< cylindrical: azimuth 0 at the horizon; stereographic: the zenith
    double widthPx = 1;   ///< cylindrical: of 360 degrees
    double heightPx = 1;  ///< cylindrical: of 90 degrees; stereographic: radius of the horizon

    [[nodiscard]] glm::dvec2 at(double azimuthDeg, double altitudeDeg) const {
        if (kind == Kind::cylindrical)
            return corner + glm::dvec2(azimuthDeg / 360 * widthPx, -altitudeDeg / 90 * heightPx);
        const double azimuth = azimuthDeg * std::numbers::pi / 180;
        const double radius = heightPx * std::tan((90 - altitudeDeg) * std::numbers::pi / 360);
        return corner + radius * glm::dvec2(std::sin(azimuth), -std::cos(azimuth));
    }
};

}  // namespace noonmark
