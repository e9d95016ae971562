#pragma once

#include <compare>
#include <numbers>

namespace noonmark {

struct Radians;

/// An angle in degrees. Core's interfaces pass angles as Degrees, or as numbers whose name carries the unit.
struct Degrees {
    double value = 0;
    constexpr auto operator<=>(const Degrees&) const = default;
    [[nodiscard]] constexpr Radians radians() const;
};

/// An angle in radians.
struct Radians {
    double value = 0;
    constexpr auto operator<=>(const Radians&) const = default;
    [[nodiscard]] constexpr Degrees degrees() const { return {value * 180.0 / std::numbers::pi}; }
};

constexpr Radians Degrees::radians() const { return {value * std::numbers::pi / 180.0}; }

/// A place on the WGS84 ellipsoid. Longitude -180 to 180, east positive; latitude -90 to 90, north positive.
struct LonLat {
    double lonDeg = 0;
    double latDeg = 0;
    constexpr bool operator==(const LonLat&) const = default;
};

}  // namespace noonmark
