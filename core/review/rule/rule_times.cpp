#include "core/review/rule/rule_times.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>

#include "core/sun/civil_time.h"

namespace noonmark {

namespace {

std::optional<double> parseOffset(std::string_view text) {
    if (text.empty()) return 0.0;
    const char sign = text.front(), unit = text.back();
    if ((sign != '+' && sign != '-') || (unit != 'h' && unit != 'm') || text.size() < 3) return std::nullopt;
    double value = 0;
    const char* const end = text.data() + text.size() - 1;
    const auto [rest, error] = std::from_chars(text.data() + 1, end, value, std::chars_format::fixed);
    const double minutes = value * (unit == 'h' ? 60 : 1);
    if (error != std::errc{} || rest != end || !(minutes >= 0 && minutes <= 720)) return std::nullopt;
    return sign == '-' ? -minutes : minutes;
}

std::string joinBounds(const std::vector<HoursBound>& bounds, std::string_view which) {
    if (bounds.size() == 1) return formatText(bounds.front());
    std::string text{which};
    for (const HoursBound& bound : bounds)
        text += fmt::format("{}{}", &bound == &bounds.front() ? " " : ", ", formatText(bound));
    return text;
}

}  // namespace

std::optional<std::chrono::month_day> parseRuleDay(std::string_view text) {
    if (text.size() != 5 || text[2] != '-') return std::nullopt;
    const auto twoDigits = [&](std::size_t at) {
        const auto digit = [&](std::size_t i) {
            return text[i] >= '0' && text[i] <= '9' ? text[i] - '0' : 99;
        };
        return unsigned(digit(at) * 10 + digit(at + 1));
    };
    const unsigned month = twoDigits(0), day = twoDigits(3);
    if (month < 1 || month > 12 || day < 1 || day > 31) return std::nullopt;
    const std::chrono::month_day date{std::chrono::month(month), std::chrono::day(day)};
    return date.ok() ? std::optional(date) : std::nullopt;
}

std::optional<double> parseRuleTime(std::string_view text) {
    if (text.size() != 5) return std::nullopt;
    const auto time = parseTimeOfDay(text);
    return time ? std::optional(double(time->count())) : std::nullopt;
}

std::optional<HoursBound> parseHoursBound(std::string_view text) {
    using enum HoursBound::Kind;
    for (const auto& [word, kind] : {std::pair{std::string_view{"sunrise"}, sunrise}, {"sunset", sunset}}) {
        if (!text.starts_with(word)) continue;
        const auto offset = parseOffset(text.substr(word.size()));
        return offset ? std::optional(HoursBound{kind, *offset}) : std::nullopt;
    }
    const auto time = parseRuleTime(text);
    return time ? std::optional(HoursBound{clock, *time}) : std::nullopt;
}

std::string formatText(std::chrono::month_day day) {
    return fmt::format("{:02}-{:02}", unsigned(day.month()), unsigned(day.day()));
}

std::string formatRuleTime(double minutes) {
    const long whole = std::lround(minutes);
    return fmt::format("{:02}:{:02}", whole / 60, whole % 60);
}

std::string formatText(const HoursBound& bound) {
    if (bound.kind == HoursBound::Kind::clock) return formatRuleTime(bound.minutes);
    const bool halfHours = std::fmod(bound.minutes, 30) == 0;
    const std::string offset = bound.minutes == 0 ? ""
                               : halfHours        ? fmt::format("{:+g}h", bound.minutes / 60)
                                                  : fmt::format("{:+g}m", bound.minutes);
    return (bound.kind == HoursBound::Kind::sunrise ? "sunrise" : "sunset") + offset;
}

std::string formatText(const HoursOfDay& hours) {
    return joinBounds(hours.from, "the latest of") + " to " + joinBounds(hours.to, "the earliest of");
}

}  // namespace noonmark
