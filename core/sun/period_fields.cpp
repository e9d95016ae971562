#include "core/sun/period_fields.h"

#include <fmt/format.h>
#include <array>
#include <cmath>
#include <cstdlib>

#include "core/describe/text.h"
#include "core/sun/period.h"

namespace noonmark {

namespace {

bool byClock(const Period& period) { return !period.window; }
bool bySun(const Period& period) { return period.window.has_value(); }

// Without the sunrise rule, which is a field of its own.
std::string formatOffsets(const SolarHours& window) {
    SolarHours offsets = window;
    offsets.rule = SunriseRule::upperLimb;
    return formatText(offsets);
}

constexpr std::array sunriseChoices{
    Choice{SunriseRule::upperLimb, "upper limb", NM_TEXT("first light of the disc (-0.833°)")},
    Choice{SunriseRule::centre, "centre", NM_TEXT("middle of the disc (0°)")}};

constexpr ValueRange offsetHours{0, 12};

double hoursOf(std::chrono::minutes minutes) { return double(minutes.count()) / 60; }

template <std::chrono::minutes SolarHours::*member>
Value getOffset(const SolarHours& window) {
    return hoursOf(window.*member);
}

template <std::chrono::minutes SolarHours::*member>
Result<void> setOffset(SolarHours& window, const Value& value) {
    if (const auto* hours = std::get_if<double>(&value))
        window.*member = std::chrono::minutes(std::lround(*hours * 60));
    return {};
}

Value getCentre(const Period& period) { return period.window && period.window->rule == SunriseRule::centre; }

Result<void> setCentre(Period& period, const Value& value) {
    if (period.window && value == Value(true)) period.window->rule = SunriseRule::centre;
    return {};
}

}  // namespace

const Fields<Period>& periodFields() {
    static const Fields<Period> fields{
        textField(&Period::start, &formatText, &parseDate,
                  {.key = "start",
                   .flag = "--start",
                   .label = NM_TEXT("First day"),
                   .help = "First day: 2026-03-21",
                   .hint = "DATE",
                   .entry = TextEntry::date,
                   .hasDefault = false,
                   .restated = true}),
        field(&Period::days, {.key = "days",
                              .flag = "--days",
                              .label = NM_TEXT("Days"),
                              .help = NM_TEXT("Number of days"),
                              .hint = "N",
                              .range = ValueRange{1, 3660},
                              .restated = true}),
        textField(&Period::window, &formatOffsets, &parseSolarHours,
                  {.key = "window",
                   .flag = "--window",
                   .label = "From sunrise to sunset",
                   .help = "Hours relative to sunrise and sunset: sunrise+1.5h..sunset-1.5h; every "
                           "minute counts",
                   .hint = "WINDOW",
                   .excludes = {"--from", "--hours"}}),
        derivedField(ValueKind::yesNo, &getCentre, &setCentre,
                     {.key = "centre",
                      .flag = "--centre",
                      .label = "Sunrise at",
                      .help = "Define sunrise and sunset of --window by the sun's centre at 0 deg, "
                              "not by its upper limb on the horizon (-0.833 deg)",
                      .needs = "--window"})
            .when(&bySun),
        textField(&Period::from, &formatText, &parseTimeOfDay,
                  {.key = "from",
                   .flag = "--from",
                   .label = NM_TEXT("From"),
                   .help = "Local time of the first step (default 09:00)",
                   .hint = "HH:MM",
                   .entry = TextEntry::timeOfDay,
                   .restated = true})
            .when(&byClock),
        field(&Period::hours, {.key = "hours",
                               .flag = "--hours",
                               .label = NM_TEXT("Hours per day"),
                               .help = NM_TEXT("Hours a day, 0 to 24; 0 is one instant"),
                               .unit = "h",
                               .range = ValueRange{0, 24},
                               .restated = true})
            .when(&byClock),
        field(&Period::stepMinutes,
              {.key = "step_min",
               .flag = "--step",
               .label = NM_TEXT("Step"),
               .help = NM_TEXT("Length of a step, minutes; adjusted so that whole steps fill the hours of "
                               "each day"),
               .unit = "min",
               .range = ValueRange{1.0 / 60, 240},
               .restated = true}),
        field(&Period::zone, {.key = "zone",
                              .flag = "--zone",
                              .label = NM_TEXT("Time zone"),
                              .help = "Time zone, for example America/New_York",
                              .hint = "ZONE",
                              .entry = TextEntry::zone,
                              .hasDefault = false,
                              .restated = true}),
        field(&Period::refraction, {.key = "refraction",
                                    .flag = "--no-refraction",
                                    .label = NM_TEXT("Sun as seen through the air"),
                                    .help = "Use the geometric position of the sun, as planning rules do"}),
    };
    return fields;
}

const Fields<SolarHours>& solarHoursFields() {
    static const Fields<SolarHours> fields{
        derivedField(ValueKind::number, &getOffset<&SolarHours::afterSunrise>,
                     &setOffset<&SolarHours::afterSunrise>,
                     {.key = "after_sunrise_h",
                      .flag = "--after-sunrise",
                      .label = NM_TEXT("After sunrise"),
                      .help = NM_TEXT("The measured hours begin this many hours after sunrise"),
                      .unit = "h",
                      .range = offsetHours}),
        derivedField(ValueKind::number, &getOffset<&SolarHours::beforeSunset>,
                     &setOffset<&SolarHours::beforeSunset>,
                     {.key = "before_sunset_h",
                      .flag = "--before-sunset",
                      .label = NM_TEXT("Before sunset"),
                      .help = NM_TEXT("The measured hours end this many hours before sunset"),
                      .unit = "h",
                      .range = offsetHours}),
        choiceField(&SolarHours::rule, sunriseChoices,
                    {.key = "sunrise_rule",
                     .flag = "--sunrise-rule",
                     .label = NM_TEXT("Sunrise at"),
                     .help = NM_TEXT("Which moment counts as sunrise and sunset: the altitude of the sun's "
                                     "centre")})};
    return fields;
}

FlagNames periodFlagsBesideScenarios() { return {{"--from", "--at"}}; }

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
