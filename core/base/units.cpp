#include "core/base/units.h"

#include <fmt/format.h>
#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <vector>

#include "core/base/wording.h"

namespace noonmark {

namespace {

// NIST SP 811
constexpr double squareFeetPerAcre = 43560;
constexpr double squareMetresPerHectare = 10000;
// From so many hectares or acres on, an area is stated in them.
constexpr double largeArea = 10;

std::string combine(UnitSystem units, const std::string& metric, const std::string& imperial) {
    if (units == UnitSystem::metric) return localNumbers(metric);
    if (units == UnitSystem::imperial) return localNumbers(imperial);
    return localNumbers(fmt::format("{} ({})", metric, imperial));
}

/// A unit that has a word of its own in other languages (texts of core/describe/figure_text.cpp).
std::string unitWord(const char* english) { return ' ' + localText(english); }

std::string formatMetricArea(double squareMetres) {
    const double hectares = squareMetres / squareMetresPerHectare;
    if (std::abs(hectares) >= largeArea) return formatNumber(hectares, 1) + " ha";
    return formatNumber(squareMetres, 0) + " m²";
}

std::string formatImperialArea(double squareMetres) {
    const double squareFeet = squareMetres / squareMetresPerSquareFoot,
                 acres = squareFeet / squareFeetPerAcre;
    if (std::abs(acres) >= largeArea) return formatNumber(acres, 1) + unitWord("acres");
    return formatNumber(squareFeet, 0) + unitWord("sq ft");
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
                   formatNumber(metres / metresPerFoot, decimals) + unitWord("ft"));
}

std::string formatArea(double squareMetres, UnitSystem units) {
    return combine(units, formatMetricArea(squareMetres), formatImperialArea(squareMetres));
}

std::string formatSmallArea(double squareMetres, UnitSystem units) {
    return combine(units, formatNumber(squareMetres) + " m²",
                   formatNumber(squareMetres / squareMetresPerSquareFoot) + unitWord("sq ft"));
}

std::string formatAreaHours(double squareMetreHours, UnitSystem units) {
    return combine(units, formatNumber(squareMetreHours, 0) + " m² h",
                   formatNumber(squareMetreHours / squareMetresPerSquareFoot, 0) + unitWord("sq ft") + " h");
}

namespace {

constexpr double inchM = metresPerFoot / 12;
constexpr double tooLongM = 1e7;

struct Unit {
    std::string_view name;
    double lengthM;
};
// Longer names before those that they begin with.
constexpr std::array lengthUnits{Unit{"feet", metresPerFoot},
                                 Unit{"foot", metresPerFoot},
                                 Unit{"ft", metresPerFoot},
                                 Unit{"inches", inchM},
                                 Unit{"inch", inchM},
                                 Unit{"in", inchM},
                                 Unit{"''", inchM},
                                 Unit{"'", metresPerFoot},
                                 Unit{"\"", inchM},
                                 Unit{"\u2032", metresPerFoot},
                                 Unit{"\u2033", inchM},
                                 Unit{"\u2019", metresPerFoot},
                                 Unit{"\u201d", inchM},
                                 Unit{"mm", 0.001},
                                 Unit{"cm", 0.01},
                                 Unit{"m", 1}};

void skipSpaces(std::string_view& text) {
    while (!text.empty() && (text.front() == ' ' || text.front() == '\t')) text.remove_prefix(1);
}

bool take(std::string_view& text, std::string_view word) {
    if (!text.starts_with(word)) return false;
    text.remove_prefix(word.size());
    return true;
}

std::optional<double> takeNumber(std::string_view& text) {
    std::string digits;
    std::size_t length = 0;
    for (const char c : text) {
        const bool point = c == '.' || c == ',';
        if (!point && (c < '0' || c > '9')) break;
        digits += point ? '.' : c;
        ++length;
    }
    double value = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (digits.empty() || error != std::errc() || end != digits.data() + digits.size()) return std::nullopt;
    text.remove_prefix(length);
    return value;
}

// "6", "6.5", "1/2", "6 1/2"
std::optional<double> takeMixedNumber(std::string_view& text) {
    auto whole = takeNumber(text);
    if (!whole) return whole;
    std::string_view rest = text;
    skipSpaces(rest);
    double upper = *whole, base = 0;
    if (!rest.starts_with('/')) {
        const auto second = takeNumber(rest);
        if (!second || !rest.starts_with('/')) return whole;
        base = *whole;
        upper = *second;
    }
    rest.remove_prefix(1);
    const auto lower = takeNumber(rest);
    if (!lower || *lower == 0) return std::nullopt;
    text = rest;
    return base + upper / *lower;
}

struct Term {
    double number = 0;
    double unitM = 0;  // 0: none was given
};

std::optional<Term> takeTerm(std::string_view& text) {
    const auto number = takeMixedNumber(text);
    if (!number) return std::nullopt;
    skipSpaces(text);
    for (const Unit& unit : lengthUnits)
        if (take(text, unit.name)) return Term{*number, unit.lengthM};
    return Term{*number, 0};
}

// Feet may be followed by inches, whose mark may be left out.
std::optional<double> addTerms(const Term& first, std::string_view& text, UnitSystem units) {
    const double alone = units == UnitSystem::imperial ? metresPerFoot : 1;
    const double sum = first.number * (first.unitM == 0 ? alone : first.unitM);
    skipSpaces(text);
    if (text.empty()) return sum;
    if (first.unitM != metresPerFoot) return std::nullopt;
    if (take(text, "-")) skipSpaces(text);
    const auto inches = takeTerm(text);
    if (!inches || (inches->unitM != 0 && inches->unitM != inchM)) return std::nullopt;
    return sum + inches->number * inchM;
}

}  // namespace

std::optional<double> parseLength(std::string_view text, UnitSystem units) {
    skipSpaces(text);
    const bool negative = take(text, "-") || take(text, "\u2212");
    if (!negative) take(text, "+");
    skipSpaces(text);
    const auto first = takeTerm(text);
    if (!first) return std::nullopt;
    const auto length = addTerms(*first, text, units);
    skipSpaces(text);
    if (!length || !text.empty() || !(*length < tooLongM)) return std::nullopt;
    return negative ? -*length : *length;
}

std::string formatFeetAndInches(double metres) {
    const auto hundredths = std::llround(std::abs(metres) / inchM * 100);
    const auto feet = hundredths / 1200;
    return fmt::format("{}{}' {:g}\"", metres < 0 && hundredths > 0 ? "-" : "", feet,
                       double(hundredths % 1200) / 100);
}

}  // namespace noonmark
