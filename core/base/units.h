#pragma once

#include <array>
#include <compare>
#include <numbers>
#include <optional>
#include <string>
#include <string_view>

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

/// The units in which results are shown. Files for machines (JSON, CSV columns, GeoTIFF) stay metric.
enum class UnitSystem {
    metric,
    imperial,
    both,  ///< metric, followed by imperial in parentheses
};

inline constexpr std::array unitSystems{UnitSystem::metric, UnitSystem::imperial, UnitSystem::both};

/// "metric", "imperial", "both": the names in project files and on the command line.
std::string_view nameOf(UnitSystem units);
/// The system of that name; nothing for any other text.
std::optional<UnitSystem> parseUnitSystem(std::string_view name);

/// International feet (NIST SP 811).
inline constexpr double metresPerFoot = 0.3048;
inline constexpr double squareMetresPerSquareFoot = metresPerFoot * metresPerFoot;

/// "1,234.5": with commas between thousands
std::string formatNumber(double value, int decimals = 0);

/// "124.3 m"; "407.8 ft"; "124.3 m (407.8 ft)". `decimals`: of the metric value, 0 to 3; feet have as many.
std::string formatLength(double metres, UnitSystem units, int decimals = 1);
/// "1,204 m²"; "12,960 sq ft"; "12.5 acres", "12.5 ha" from ten of them on.
std::string formatArea(double squareMetres, UnitSystem units);
/// "125,204 m²"; "1,347,685 sq ft": never in hectares or acres.
std::string formatSmallArea(double squareMetres, UnitSystem units);
/// "1,204 m² h"; "12,960 sq ft h", square-foot-hours.
std::string formatAreaHours(double squareMetreHours, UnitSystem units);

/// A length as people type it, in metres: "3.5 m", "350 cm", "12' 6\"", "12'-6 1/2\"", "12 ft 6 in", "150\"",
/// with a decimal point or comma and the typographic primes too. A number alone is in feet if `units` is
/// imperial, else in metres; inches alone need their mark. Nothing for any other text, and for 1e7 m or more.
std::optional<double> parseLength(std::string_view text, UnitSystem units);

/// "12' 6\"", "-0' 3.25\"": whole feet and inches, rounded to 0.01 inch.
std::string formatFeetAndInches(double metres);

}  // namespace noonmark
