#include "core/engines/points/point_sunlight.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <numeric>

#include "core/engines/common/run_counter.h"
#include "core/engines/common/sun_packets.h"
#include "core/engines/ray/surface_rays.h"
#include "core/simd/flush_denormals.h"

namespace noonmark {

namespace {

std::chrono::milliseconds lengthOf(double stepMinutes) {
    return std::chrono::round<std::chrono::milliseconds>(
        std::chrono::duration<double, std::ratio<60>>(stepMinutes));
}

Instant endOf(const SunStep& step, const SunSteps& sun) { return step.at + lengthOf(sun.stepMinutes); }

// The first instant in the dark between a lit and a dark one, in either order of time.
Instant findChange(Instant lit, Instant dark, const std::function<bool(Instant)>& isLit) {
    while (std::chrono::abs(lit - dark) > std::chrono::milliseconds(100)) {
        const Instant middle = lit + (dark - lit) / 2;
        (isLit(middle) ? lit : dark) = middle;
    }
    return lit;
}

}  // namespace

ShadedSteps findShadedSteps(const Skyline& skyline, const SunSteps& sun) {
    ShadedSteps shaded(sun.steps.size());
    for (std::size_t i = 0; i < shaded.size(); ++i) shaded[i] = skyline.hides(sun.steps[i].direction) ? 1 : 0;
    return shaded;
}

ShadedSteps traceShadedSteps(const RayScene& scene, const SkyPoint& point, const SunSteps& sun) {
    const FlushDenormals flush;
    const glm::vec3 origin = placeSurfaceRayOrigin(point.position, point.normal);
    ShadedSteps shaded(sun.steps.size());
    std::size_t step = 0;
    for (const SunPacket& packet : packSteps(sun)) {
        std::uint32_t blocked = 0;
        scene.blockedLanes({&origin, 1}, packet.directions, {&blocked, 1});
        for (int lane = 0; lane < packet.directions.count; ++lane, ++step) {
            const bool away = glm::dot(sun.steps[step].direction, point.normal) <= 0;
            shaded[step] = away || (blocked >> unsigned(lane) & 1U) != 0 ? 1 : 0;
        }
    }
    return shaded;
}

std::vector<SunBand> findSunBands(const ShadedSteps& shaded, const SunSteps& sun, std::size_t day) {
    std::vector<SunBand> bands;
    const SunDay& steps = sun.days[day];
    std::int32_t slotBefore = -2;
    for (std::uint32_t i = steps.first; i < steps.first + steps.count; ++i) {
        if (shaded[i] != 0) continue;
        const SunStep& step = sun.steps[i];
        if (step.slot == slotBefore + 1)
            bands.back().to = endOf(step, sun);
        else
            bands.push_back({step.at, endOf(step, sun)});
        slotBefore = step.slot;
    }
    return bands;
}

void refineSunBands(std::vector<SunBand>& bands, double stepMinutes,
                    const std::function<bool(Instant)>& isLit) {
    const auto step = lengthOf(stepMinutes);
    for (SunBand& band : bands) {
        if (!isLit(band.from - step)) band.from = findChange(band.from, band.from - step, isLit);
        if (!isLit(band.to)) band.to = findChange(band.to - step, band.to, isLit);
    }
}

PointShadow countShadow(const ShadedSteps& shaded, const SunSteps& sun) {
    RunCounter runs;
    for (const SunDay& day : sun.days) {
        std::int32_t slotBefore = -2;
        for (std::uint32_t i = day.first; i < day.first + day.count; ++i) {
            runs.add(shaded[i], sun.steps[i].slot == slotBefore + 1 ? 0U : 1U, 1);
            slotBefore = sun.steps[i].slot;
        }
    }
    return {runs.total() * sun.stepMinutes / std::max(1.0, double(sun.dayCount())),
            runs.longest() * sun.stepMinutes};
}

MonthHours sumSunlight(const ShadedSteps& shaded, const SunSteps& sun, const Zone& zone) {
    MonthHours sums{};
    for (const SunDay& day : sun.days)
        for (std::uint32_t i = day.first; i < day.first + day.count; ++i) {
            if (shaded[i] != 0) continue;
            const auto at = std::chrono::floor<std::chrono::seconds>(sun.steps[i].at);
            const auto clock = (at + zone.offsetAt(at)).time_since_epoch();
            const auto hour = (clock / std::chrono::hours(1)) % 24;
            sums[unsigned(day.date.month()) - 1][std::size_t((hour + 24) % 24)] += sun.stepMinutes;
        }
    return sums;
}

std::array<double, 12> sumMonths(const MonthHours& hours) {
    std::array<double, 12> months{};
    for (std::size_t month = 0; month < 12; ++month)
        months[month] = std::accumulate(hours[month].begin(), hours[month].end(), 0.0);
    return months;
}

}  // namespace noonmark
