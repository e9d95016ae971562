#pragma once

#include <cmath>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <numbers>
#include <optional>
#include <vector>

#include "core/engines/points/sky_obstacles.h"

namespace noonmark {

/// Altitudes that something hides at one azimuth, as tangents: those between low and high.
struct HiddenAltitudes {
    double lowTan = 0;
    double highTan = 0;  ///< infinite: up to the zenith
    bool operator==(const HiddenAltitudes&) const = default;
};

/// What a face hides at an azimuth above the point's level; none where it is not seen.
std::optional<HiddenAltitudes> hiddenBy(const OverhangFace& face, glm::dvec3 point, double azimuth);
/// The same with (sine, cosine) of the azimuth, for many faces at one.
std::optional<HiddenAltitudes> hiddenBy(const OverhangFace& face, glm::dvec3 point, glm::dvec2 direction);

/// Sorts the intervals and joins those that overlap.
void joinOverlaps(std::vector<HiddenAltitudes>& hidden);

/// A straight edge as seen from a point. An edge lies in a plane through the point, so the tangent of its
/// altitude is east sin(azimuth) + north cos(azimuth): exact, without bins.
struct SeenEdge {
    double from = 0,
           to = 0;  ///< azimuths, radians from north, clockwise; 0 <= from < 2 pi, from < to < from + pi
    double east = 0, north = 0;
    std::uint32_t building = 0;

    [[nodiscard]] double tanAt(double azimuth) const {
        return east * std::sin(azimuth) + north * std::cos(azimuth);
    }
};

inline constexpr double fullTurn = 2 * std::numbers::pi;

/// 0 <= azimuth < 2 pi
inline double azimuthOf(glm::dvec3 direction) {
    const double azimuth = std::atan2(direction.x, direction.y);
    return azimuth < 0 ? azimuth + fullTurn : azimuth;
}

/// The edge between two places given relative to the point. None if it is seen end-on.
inline std::optional<SeenEdge> seeEdge(glm::dvec3 a, glm::dvec3 b, std::uint32_t building) {
    const double turn = a.y * b.x - a.x * b.y;  // positive: b is clockwise of a
    constexpr double endOn = 1e-12;             // square metres
    if (std::abs(turn) < endOn) return std::nullopt;
    SeenEdge edge{.east = (b.z * a.y - a.z * b.y) / turn,
                  .north = (a.z * b.x - b.z * a.x) / turn,
                  .building = building};
    edge.from = azimuthOf(turn > 0 ? a : b);
    edge.to = azimuthOf(turn > 0 ? b : a);
    if (edge.to < edge.from) edge.to += fullTurn;
    if (!(edge.to > edge.from)) return std::nullopt;
    return edge;
}

/// The edge as seen from a point; none if it hides nothing above the point's level.
inline std::optional<SeenEdge> seeEdge(const TopEdge& edge, glm::dvec3 point) {
    const glm::dvec3 a = glm::dvec3(edge.a) - point, b = glm::dvec3(edge.b) - point;
    if (a.z <= 0 && b.z <= 0) return std::nullopt;
    if (edge.oneSided && a.x * b.y - a.y * b.x > 0)
        return std::nullopt;  // the point is on the interior's side
    return seeEdge(a, b, edge.building);
}

}  // namespace noonmark
