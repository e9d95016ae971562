#include "core/sun/sun_steps.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>
#include <cmath>
#include <glm/geometric.hpp>
#include <optional>

#include "core/describe/text.h"
#include "core/sun/day_clock.h"

namespace noonmark {

namespace {

using namespace std::chrono;

constexpr double millisecondsPerMinute = 60000;
constexpr double maxSteps = 50'000'000;  // 1.6 GB

/// The window of one day and its whole steps, before the horizon is considered.
struct Window {
    Instant from;
    double minutes = 0;
    std::int64_t steps = 0;
    [[nodiscard]] double stepMinutes() const { return minutes / double(steps); }
};

double stepMinutesOf(const Period& period) {
    const bool instant = !period.window && period.hours == 0;
    return instant ? 1 : period.stepMinutes;
}

/// Divides a window into equal steps as near to the requested step as possible; at least one if the window is
/// not empty. A window that the step divides, apart from rounding, gets exactly that step.
Window fillHours(Instant from, double minutes, double stepMinutes) {
    constexpr double rounding = 1e-6;  // as a share of a step: 6 h of 0.1 min are 3600 steps
    if (!(minutes > rounding * stepMinutes)) return {from};
    const std::int64_t steps = std::max<std::int64_t>(1, std::llround(minutes / stepMinutes));
    const double chosen = double(steps) * stepMinutes;
    return {from, std::abs(chosen - minutes) <= rounding * stepMinutes ? chosen : minutes, steps};
}

/// If there is no sunrise or sunset because the sun stays up, the civil day bounds the window.
Window solarHours(const SunEvents& events, const SolarHours& window, Instant midnight, Instant nextMidnight,
                  double stepMinutes) {
    if (events.kind == DayKind::polarNight) return {midnight};
    const Instant from = events.sunrise ? *events.sunrise + window.afterSunrise : midnight;
    const Instant to = events.sunset ? *events.sunset - window.beforeSunset : nextMidnight;
    return fillHours(from, double(milliseconds(to - from).count()) / 60'000, stepMinutes);
}

/// The direction of a sun above the observer's horizon, in the frame of the geometry. Far from the frame's
/// origin the sun may be below that frame's horizontal plane; it is then moved just above the plane, since
/// engines expect z > 0.
struct FramedSun {
    glm::vec3 direction;
    bool levelled = false;
};

FramedSun inFrame(const glm::dmat3& frameFromPlace, Degrees azimuth, Degrees altitude) {
    constexpr double minZ = 1e-6;  // 0.00006 degrees
    glm::dvec3 towards = frameFromPlace * toDirection(azimuth, altitude);
    const bool levelled = towards.z <= 0;
    if (levelled) towards.z = minZ;
    return {glm::vec3(glm::normalize(towards)), levelled};
}

/// The steps of one day.
struct DaySteps {
    SunDay day;
    std::vector<SunStep> steps;
    std::size_t levelled = 0;
    Window window;
};

/// Computes the steps of windows independently of each other.
class HoursSteps {
public:
    HoursSteps(const Ephemeris& sun, const glm::dmat3& frameFromPlace, const StepRule& rule)
        : sun_(sun), frameFromPlace_(frameFromPlace), rule_(rule) {}

    [[nodiscard]] DaySteps in(const Window& window, CivilDate date) const {
        DaySteps made{{date}, {}, 0, window};
        made.steps.reserve(std::size_t(window.steps));
        for (std::int64_t slot = 0; slot < window.steps; ++slot) {
            const auto step = stepAt(window, slot, made.levelled);
            if (step) made.steps.push_back(*step);
        }
        made.day.count = std::uint32_t(made.steps.size());
        made.day.belowHorizon = std::uint32_t(window.steps) - made.day.count;
        return made;
    }

private:
    /// Nothing if the sun is below the horizon, or below the lowest altitude that counts.
    [[nodiscard]] std::optional<SunStep> stepAt(const Window& window, std::int64_t slot,
                                                std::size_t& levelled) const {
        const double sinceFrom = double(slot) * window.stepMinutes() * millisecondsPerMinute;
        const Instant at = window.from + milliseconds{std::llround(sinceFrom)};
        const SolarPosition position = sun_.at(at);
        const Degrees altitude = rule_.refraction ? position.altitudeApparent : position.altitude;
        if (!(float(altitude.value) > rule_.minAltitude.value)) return std::nullopt;
        const float azimuth = float(position.azimuth.value);  // 359.99999 rounds to 360
        const FramedSun sun = inFrame(frameFromPlace_, position.azimuth, altitude);
        levelled += sun.levelled ? 1 : 0;
        return SunStep{sun.direction, azimuth < 360 ? azimuth : 0, float(altitude.value), std::int32_t(slot),
                       at};
    }

    const Ephemeris& sun_;
    const glm::dmat3& frameFromPlace_;
    StepRule rule_;
};

/// The windows of a period's days.
class PeriodHours {
public:
    PeriodHours(const Period& period, const Zone& zone, const Ephemeris& sun)
        : period_(period), zone_(zone), sun_(sun), step_(stepMinutesOf(period)) {}

    [[nodiscard]] Window on(CivilDate date) const {
        if (period_.window) {
            const Instant midnight = zone_.instantAt(date, 0min);
            const SunEvents events = computeSunEvents(sun_, midnight, period_.window->rule);
            return solarHours(events, *period_.window, midnight, zone_.instantAt(date, 24h), step_);
        }
        const Instant from = zone_.instantAt(date, period_.from);
        return fillHours(from, period_.hours == 0 ? step_ : period_.hours * 60, step_);
    }

private:
    const Period& period_;
    const Zone& zone_;
    const Ephemeris& sun_;
    double step_;
};

std::vector<DaySteps> allDays(std::size_t count, const std::stop_token& stop, const auto& stepsOf) {
    std::vector<DaySteps> made(count);
    tbb::parallel_for(std::size_t{0}, made.size(), [&](std::size_t i) {
        if (stop.stop_requested()) return;
        made[i] = stepsOf(i);
    });
    return made;
}

/// Gives every step the same weight, the mean over all days, so that the steps add up to the hours of the
/// period.
void weigh(SunSteps& sun, std::span<const DaySteps> days, double stepMinutes) {
    std::int64_t steps = 0;
    for (const auto& day : days) {
        sun.countedMinutes += day.window.minutes;
        steps += day.window.steps;
    }
    const double mean = steps == 0 ? stepMinutes : sun.countedMinutes / double(steps);
    const bool asChosen = std::abs(mean - stepMinutes) <= 1e-12 * stepMinutes;
    sun.stepMinutes = asChosen ? stepMinutes : mean;
    for (const auto& day : days) {
        const double off = double(day.window.steps) * sun.stepMinutes - day.window.minutes;
        sun.maxOffADayMin = std::max(sun.maxOffADayMin, std::abs(off));
    }
}

SunSteps joinDays(std::vector<DaySteps> days, double stepMinutes) {
    SunSteps sun;
    weigh(sun, days, stepMinutes);
    std::size_t count = 0;
    for (const auto& day : days) count += day.steps.size();
    sun.steps.reserve(count);
    for (auto& [day, steps, levelled, window] : days) {
        day.first = std::uint32_t(sun.steps.size());
        sun.belowHorizon += day.belowHorizon;
        sun.levelled += levelled;
        sun.days.push_back(day);
        sun.steps.insert(sun.steps.end(), steps.begin(), steps.end());
        steps = {};
    }
    return sun;
}

std::optional<Error> tooManySteps(double steps) {
    if (steps <= maxSteps) return std::nullopt;
    return Error{fmt::format("The period has up to {:.0f} million steps, which need {:.1f} GB", steps / 1e6,
                             steps * sizeof(SunStep) / 1e9),
                 "step", NM_TEXT("Choose a longer step or fewer days; the limit is 50 million steps")};
}

double maxStepsOf(const Period& period) {
    const double hours = period.window ? 24 : period.hours;
    return period.days * hours * 60 / period.stepMinutes;
}

}  // namespace

Result<SunSteps> computeSunSteps(const Period& period, const Observer& observer,
                                 const std::stop_token& stop) {
    if (const auto good = validate(period); !good) return tl::make_unexpected(good.error());
    if (const auto error = tooManySteps(maxStepsOf(period))) return tl::make_unexpected(*error);
    const auto zone = Zone::named(period.zone);
    if (!zone) return tl::make_unexpected(zone.error());
    const Instant first = zone->instantAt(period.start, 0min) - days{2};
    const Instant last = zone->instantAt(period.start, days{period.days}) + days{2};
    auto sun = Ephemeris::over(observer, first, last);
    if (!sun) return tl::make_unexpected(sun.error());
    const PeriodHours windows(period, *zone, *sun);
    const HoursSteps steps(*sun, observer.frameFromPlace, {stepMinutesOf(period), period.refraction, {0}});
    auto days = allDays(std::size_t(period.days), stop, [&](std::size_t i) {
        const CivilDate date{sys_days{period.start} + std::chrono::days{i}};
        return steps.in(windows.on(date), date);
    });
    if (stop.stop_requested()) return cancelled();
    return joinDays(std::move(days), stepMinutesOf(period));
}

Result<SunSteps> computeSunSteps(std::span<const DayHours> windows, const StepRule& rule,
                                 const Observer& observer, const std::stop_token& stop) {
    double minutes = 0;
    for (const DayHours& window : windows) minutes += std::max(0.0, window.minutes);
    if (auto error = tooManySteps(minutes / rule.stepMinutes)) return tl::make_unexpected(*error);
    if (windows.empty()) return SunSteps{.stepMinutes = rule.stepMinutes};
    const Instant first = windows.front().from - days{2};
    const Instant last = windows.back().from + days{4};
    auto sun = Ephemeris::over(observer, first, last);
    if (!sun) return tl::make_unexpected(sun.error());
    const HoursSteps steps(*sun, observer.frameFromPlace, rule);
    auto days = allDays(windows.size(), stop, [&](std::size_t i) {
        return steps.in(fillHours(windows[i].from, windows[i].minutes, rule.stepMinutes), windows[i].date);
    });
    if (stop.stop_requested()) return cancelled();
    return joinDays(std::move(days), rule.stepMinutes);
}

Result<SunSteps> computeDaylightSteps(const Period& period, const Observer& observer,
                                      const std::stop_token& stop) {
    auto sun = computeSunSteps(period, observer, stop);
    if (sun && sun->steps.empty())
        return failure(NM_TEXT("The sun is below the horizon all the time"), formatText(period),
                       NM_TEXT("Choose other hours or days"));
    return sun;
}

SunSteps chooseDays(const SunSteps& sun, std::span<const std::size_t> days) {
    SunSteps chosen;
    chosen.stepMinutes = sun.stepMinutes;
    for (const std::size_t number : days) {
        SunDay day = sun.days[number];
        const auto from = sun.steps.begin() + day.first;
        day.first = std::uint32_t(chosen.steps.size());
        chosen.steps.insert(chosen.steps.end(), from, from + day.count);
        chosen.belowHorizon += day.belowHorizon;
        chosen.days.push_back(day);
    }
    return chosen;
}

}  // namespace noonmark
