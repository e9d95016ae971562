#include "core/sun/period.h"

#include <fmt/format.h>

#include <cmath>

#include "core/base/safe_text.h"
#include "core/describe/field_values.h"
#include "core/describe/text.h"
#include "core/sun/period_fields.h"

namespace noonmark {

namespace {

using namespace std::chrono;

constexpr auto firstYear = 1900y;
constexpr auto lastYear = 2100y;

std::optional<Error> checkDates(const Period& period) {
    if (!period.start.ok())
        return Error{NM_TEXT("The start is not a date of the calendar"), "start",
                     NM_TEXT("Give a date such as 2026-03-21")};
    const year_month_day last{sys_days{period.start} + days{period.days - 1}};
    if (period.start.year() >= firstYear && last.year() <= lastYear) return std::nullopt;
    return Error{fmt::format("The period from {} to {} is not within the years 1900 to 2100",
                             formatText(period.start), formatText(last)),
                 "start",
                 NM_TEXT("Choose other dates; the position of the sun is known for these years only")};
}

std::optional<Error> checkHours(const Period& period) {
    if (period.from < 0min || period.from > 24h) {
        return Error{NM_TEXT("The time of day at which the hours begin is out of range"), "from",
                     NM_TEXT("Give 00:00 to 24:00")};
    }
    constexpr double minHours = 1.0 / 3600;
    if (period.hours > 0 && period.hours < minHours) {
        return Error{fmt::format("{:g} hours per day are less than a second", period.hours), "hours",
                     NM_TEXT("Give 0 (one instant), or 0.00028 to 24")};
    }
    return std::nullopt;
}

std::optional<Error> checkSolarHours(const SolarHours& window) {
    if (abs(window.afterSunrise) <= 12h && abs(window.beforeSunset) <= 12h) return std::nullopt;
    return Error{NM_TEXT("The hours after sunrise or before sunset are out of range"), "window",
                 NM_TEXT("Give at most 12 hours on either side")};
}

std::string hoursText(const Period& period) {
    if (period.window) return formatText(*period.window);
    if (period.hours == 0) return fmt::format("at {}", formatText(period.from));
    return fmt::format("{} for {:g} h", formatText(period.from), period.hours);
}

/// "+1.5h", "-30m"; nothing for 0.
std::string offsetText(minutes offset) {
    if (offset == 0min) return {};
    const bool halfHours = offset % 30min == 0min;
    return halfHours ? fmt::format("{:+g}h", double(offset.count()) / 60)
                     : fmt::format("{:+}m", offset.count());
}

}  // namespace

Result<Period> validate(const Period& period) {
    if (auto ranges = checkRanges(periodFields().of(period)); !ranges)
        return tl::make_unexpected(ranges.error());
    for (const auto& error : {checkDates(period), checkHours(period)}) {
        if (error) return tl::make_unexpected(*error);
    }
    if (period.window) {
        if (const auto error = checkSolarHours(*period.window)) return tl::make_unexpected(*error);
    }
    if (const auto zone = Zone::named(period.zone); !zone) return tl::make_unexpected(zone.error());
    return period;
}

std::string formatText(const SolarHours& window) {
    return fmt::format("sunrise{}..sunset{}{}", offsetText(window.afterSunrise),
                       offsetText(-window.beforeSunset),
                       window.rule == SunriseRule::centre ? " (sun's centre)" : "");
}

std::string formatText(const Period& period) {
    const bool instant = !period.window && period.hours == 0;
    return fmt::format("{}, {}, {}{}, {}{}", formatText(period.start),
                       countOf(std::uint64_t(period.days), "day"), hoursText(period),
                       instant ? "" : fmt::format(", every {:g} min", period.stepMinutes), period.zone,
                       period.refraction ? "" : ", no refraction");
}

}  // namespace noonmark
