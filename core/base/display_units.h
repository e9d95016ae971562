#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

namespace noonmark {

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

}  // namespace noonmark
