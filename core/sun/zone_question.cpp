#include "core/sun/zone_question.h"

#include <fmt/format.h>

#include <cmath>

namespace noonmark {

std::optional<Warning> questionZone(const Period& period, LonLat place) {
    constexpr double maxHours = 4, degreesPerHour = 15;
    const auto zone = Zone::named(period.zone);
    if (!zone || period.zone.find('/') == std::string::npos || period.zone.starts_with("Etc/"))
        return std::nullopt;
    const auto noon = std::chrono::sys_days(period.start) + std::chrono::hours(12);
    const double clockH = double(zone->offsetAt(noon).count()) / 3600;
    const double apartH = std::abs(std::remainder(clockH - place.lonDeg / degreesPerHour, 24.0));
    if (apartH <= maxHours) return std::nullopt;
    return Warning{
        WarningKind::assumed,
        fmt::format("the clocks of the zone are {:.1f} h from the sun's time here: is it the right zone?",
                    apartH),
        period.zone};
}

}  // namespace noonmark
