#include "core/base/display_units.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace noonmark {

namespace {

// NIST SP 811
constexpr double squareFeetPerAcre = 43560;
constexpr double squareMetresPerHectare = 10000;
// From so many hectares or acres on, an area is stated in them.
constexpr double largeArea = 10;

std::string combine(UnitSystem units, const std::string& metric, const std::string& imperial) {
    if (units == UnitSystem::metric) return metric;
    if (units == UnitSystem::imperial) return imperial;
    return fmt::format("{} ({})", metric, imperial);
}

std::string formatMetricArea(double squareMetres) {
    const double hectares = squareMetres / squareMetresPerHectare;
    if (std::abs(hectares) >= largeArea) return formatNumber(hectares, 1) + " ha";
    return formatNumber(squareMetres, 0) + " m²";
}

std::string formatImperialArea(double squareMetres) {
    const double squareFeet = squareMetres / squareMetresPerSquareFoot,
                 acres = squareFeet / squareFeetPerAcre;
    if (std::abs(acres) >= largeArea) return formatNumber(acres, 1) + " acres";
    return formatNumber(squareFeet, 0) + " sq ft";
}

}  // namespace

std::string formatNumber(double value, int decimals) {
    std::string text = fmt::format("{:.{}f}", value, decimals);
    // What rounds to zero has no sign.
    if (text.starts_with('-') && text.find_first_not_of("-0.") == std::string::npos) text.erase(0, 1);
    const auto first = std::ptrdiff_t(text.starts_with('-') ? 1 : 0);
    const auto whole = std::ptrdiff_t(std::min(text.find('.'), text.size()));
    for (std::ptrdiff_t at = whole - 3; at > first; at -= 3) text.insert(std::size_t(at), 1, ',');
    return text;
}

std::string_view nameOf(UnitSystem units) {
    switch (units) {
        case UnitSystem::metric:
            return "metric";
        case UnitSystem::imperial:
            return "imperial";
        case UnitSystem::both:
            return "both";
    }
    return "metric";
}

std::optional<UnitSystem> parseUnitSystem(std::string_view name) {
    for (const UnitSystem units : unitSystems)
        if (nameOf(units) == name) return units;
    return std::nullopt;
}

std::string formatLength(double metres, UnitSystem units, int decimals) {
    return combine(units, formatNumber(metres, decimals) + " m",
                   formatNumber(metres / metresPerFoot, decimals) + " ft");
}

std::string formatArea(double squareMetres, UnitSystem units) {
    return combine(units, formatMetricArea(squareMetres), formatImperialArea(squareMetres));
}

std::string formatSmallArea(double squareMetres, UnitSystem units) {
    return combine(units, formatNumber(squareMetres) + " m²",
                   formatNumber(squareMetres / squareMetresPerSquareFoot) + " sq ft");
}

std::string formatAreaHours(double squareMetreHours, UnitSystem units) {
    return combine(units, formatNumber(squareMetreHours, 0) + " m² h",
                   formatNumber(squareMetreHours / squareMetresPerSquareFoot, 0) + " sq ft h");
}

}  // namespace noonmark
