#include <fmt/format.h>

#include <cmath>
#include <cstdlib>

#include "core/sun/period.h"

namespace noonmark {

namespace {

using std::chrono::minutes;

constexpr auto advice = "Write it like sunrise+1.5h..sunset-1.5h or sunrise-30m..sunset+30m";

/// Lower case, no blanks.
std::string compact(std::string_view text) {
    std::string result;
    for (const char c : text) {
        if (c == ' ' || c == '\t') continue;
        result += c >= 'A' && c <= 'Z' ? char(c - 'A' + 'a') : c;
    }
    return result;
}

void dropPrefix(std::string_view& text, std::string_view prefix) {
    if (text.starts_with(prefix)) text.remove_prefix(prefix.size());
}

/// Minutes per unit; 0 for an unknown unit.
double minutesOf(std::string_view unit) {
    if (unit == "h" || unit == "hours" || unit == "hour") return 60;
    if (unit == "m" || unit == "min" || unit == "minutes") return 1;
    return 0;
}

/// Number of leading characters that are digits with at most one point.
std::size_t numberLength(std::string_view text) {
    const std::size_t end = std::min(text.find_first_not_of("0123456789."), text.size());
    const std::string_view number = text.substr(0, end);
    const bool good =
        number.find_first_of("0123456789") != std::string_view::npos && number.find('.') == number.rfind('.');
    return good ? end : 0;
}

/// "1.5h", "90m" in whole minutes.
std::optional<minutes> duration(std::string_view text) {
    const std::size_t length = numberLength(text);
    const double unit = minutesOf(text.substr(length));
    if (length == 0 || unit == 0) return std::nullopt;
    const double value = std::strtod(std::string(text.substr(0, length)).c_str(), nullptr) * unit;
    constexpr double maxMinutes = 12 * 60;
    if (value > maxMinutes || std::abs(value - std::round(value)) > 1e-6) return std::nullopt;
    return minutes{std::lround(value)};
}

/// Minutes after `event` ("sunrise" or "sunset"): a sign says before or after; without a sign the hours count
/// into the day.
std::optional<minutes> offset(std::string_view text, std::string_view event, int intoDay) {
    dropPrefix(text, event);
    if (text.empty()) return minutes{0};
    const bool minus = text.front() == '-';
    const bool plus = text.front() == '+';
    if (minus || plus) text.remove_prefix(1);
    const auto size = duration(text);
    if (!size) return std::nullopt;
    return *size * (minus ? -1 : plus ? 1 : intoDay);
}

}  // namespace

Result<SolarHours> parseSolarHours(std::string_view text) {
    const std::string plain = compact(text);
    const std::size_t dots = plain.find("..");
    if (dots == std::string::npos)
        return failure(fmt::format("\"{}\" is not a solar window", text), "window", advice);
    const auto start = offset(std::string_view(plain).substr(0, dots), "sunrise", 1);
    const auto end = offset(std::string_view(plain).substr(dots + 2), "sunset", -1);
    if (!start || !end) {
        return failure(
            fmt::format(
                "\"{}\" is not a solar window of whole minutes, at most 12 hours from sunrise and sunset",
                text),
            "window", advice);
    }
    return SolarHours{*start, -*end};
}

}  // namespace noonmark
