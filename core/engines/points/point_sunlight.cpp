#include "core/engines/points/point_sunlight.h"

#include <fmt/format.h>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <algorithm>
#include <atomic>
#include <glm/geometric.hpp>
#include <numeric>

#include "core/base/progress.h"
#include "core/describe/text.h"
#include "core/engines/common/run_counter.h"
#include "core/engines/common/sun_packets.h"
#include "core/engines/points/point_horizons.h"
#include "core/engines/ray/surface_rays.h"
#include "core/simd/flush_denormals.h"

namespace noonmark {

Result<ShadedStepFinder> ShadedStepFinder::over(const City& city, const SunSteps& sun, By by,
                                                const std::stop_token& stop) {
    auto rays = RayScene::over(city, stop);
    if (!rays) return tl::make_unexpected(rays.error());
    ShadedStepFinder finder(*std::move(rays), sun);
    if (by == By::horizons) finder.horizons_ = std::make_shared<const HorizonScene>(city, sun, true);
    return finder;
}

ShadedSteps ShadedStepFinder::find(const SkyPoint& point) const {
    if (!horizons_) return traceShadedSteps(rays_, point, *sun_);
    const FlushDenormals flush;
    HorizonOfPoint horizon(*horizons_);
    horizon.sweep(point.position, point.normal);
    ShadedSteps shaded;
    horizon.findShadedSteps(shaded);
    const glm::vec3 origin = placeSurfaceRayOrigin(point.position, point.normal);
    for (const SunDay& day : sun_->days) correctDay(day, origin, point.normal, shaded);
    return shaded;
}

// Walks from each change outward, first back, then forth, while rays contradict the horizon.
void ShadedStepFinder::correctDay(const SunDay& day, glm::vec3 origin, glm::vec3 normal,
                                  ShadedSteps& shaded) const {
    const std::uint32_t end = day.first + day.count;
    const auto isCorrected = [&](std::uint32_t step) {
        const glm::vec3 direction = sun_->steps[step].direction;
        const bool hidden = glm::dot(direction, normal) <= 0 || rays_.occluded(origin, direction);
        const bool wrong = hidden != (shaded[step] != 0);
        if (wrong) shaded[step] = hidden ? 1 : 0;
        return wrong;
    };
    for (std::uint32_t step = day.first + 1; step < end; ++step) {
        if (shaded[step] == shaded[step - 1]) continue;
        std::uint32_t back = step;
        while (back > day.first && isCorrected(back - 1)) --back;
        while (step < end && isCorrected(step)) ++step;
    }
}

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
    std::vector<float> shares(shaded.size());
    std::ranges::transform(shaded, shares.begin(),
                           [](std::uint8_t isShaded) { return isShaded != 0 ? 0.F : 1.F; });
    return sumSunlight(shares, sun, zone);
}

MonthHours sumSunlight(const std::vector<float>& shares, const SunSteps& sun, const Zone& zone) {
    MonthHours sums{};
    for (const SunDay& day : sun.days)
        for (std::uint32_t i = day.first; i < day.first + day.count; ++i) {
            if (shares[i] <= 0) continue;
            const auto at = std::chrono::floor<std::chrono::seconds>(sun.steps[i].at);
            const auto clock = (at + zone.offsetAt(at)).time_since_epoch();
            const auto hour = (clock / std::chrono::hours(1)) % 24;
            sums[unsigned(day.date.month()) - 1][std::size_t((hour + 24) % 24)] +=
                double(shares[i]) * sun.stepMinutes;
        }
    return sums;
}

std::array<double, 12> sumMonths(const MonthHours& hours) {
    std::array<double, 12> months{};
    for (std::size_t month = 0; month < 12; ++month)
        months[month] = std::accumulate(hours[month].begin(), hours[month].end(), 0.0);
    return months;
}

namespace {

/// What the rays of all points have in common.
struct TraceScene {
    RayScene scene;
    std::vector<SunPacket> packets;
    std::vector<std::uint8_t> monthOfStep;  // 0 to 11
    double stepMinutes;
};

std::vector<std::uint8_t> monthsOfSteps(const SunSteps& sun) {
    std::vector<std::uint8_t> months(sun.steps.size());
    for (const SunDay& day : sun.days)
        std::fill_n(months.begin() + day.first, day.count, std::uint8_t(unsigned(day.date.month()) - 1));
    return months;
}

std::uint32_t turnedAway(glm::vec3 normal, const DirectionPacket& sun) {
    std::uint32_t away = 0;
    for (int lane = 0; lane < sun.count; ++lane) {
        const auto k = std::size_t(lane);
        if (normal.x * sun.x[k] + normal.y * sun.y[k] + normal.z * sun.z[k] <= 0)
            away |= 1U << unsigned(lane);
    }
    return away;
}

// Returns the number of rays.
std::uint64_t tracePoint(const TraceScene& trace, glm::vec3 position, glm::vec3 normal, std::size_t point,
                         PointMonths& result) {
    const glm::vec3 origin = placeSurfaceRayOrigin(position, normal);
    std::array<std::uint32_t, 12> months{};
    RunCounter shadow, sun;
    std::uint64_t rays = 0;
    std::size_t step = 0;
    for (const SunPacket& packet : trace.packets) {
        const int count = packet.directions.count;
        const auto all = std::uint32_t((1ULL << unsigned(count)) - 1);
        const std::uint32_t away = turnedAway(normal, packet.directions);
        std::uint32_t blocked = 0;
        if (away != all) trace.scene.blockedLanes({&origin, 1}, packet.directions, {&blocked, 1});
        if (away != all) rays += std::uint64_t(count);
        const std::uint32_t lit = ~(blocked | away) & all;
        shadow.add(all & ~lit, packet.starts, count);
        sun.add(lit, packet.starts, count);
        for (int lane = 0; lane < count; ++lane, ++step)
            months[trace.monthOfStep[step]] += lit >> unsigned(lane) & 1U;
    }
    for (std::size_t month = 0; month < 12; ++month)
        result.sunlitMin[point][month] = float(months[month] * trace.stepMinutes);
    result.longestShadowMin[point] = float(shadow.longest() * trace.stepMinutes);
    result.longestSunMin[point] = float(sun.longest() * trace.stepMinutes);
    return rays;
}

}  // namespace

Result<PointMonths> tracePoints(const City& city, const SurfacePoints& points, const SunSteps& sun,
                                Progress& progress, const std::stop_token& stop,
                                std::optional<RayScene> scene) {
    if (points.positions.size() != points.normals.size())
        return failure(
            fmt::format("{} places have {} normals", points.positions.size(), points.normals.size()),
            "surface points", "Give each place the direction that its surface faces");
    const Stopwatch build;
    if (!scene) {
        auto made = RayScene::over(city, stop);
        if (!made) return tl::make_unexpected(made.error());
        scene = *std::move(made);
    }
    const TraceScene trace{*std::move(scene), packSteps(sun), monthsOfSteps(sun), sun.stepMinutes};
    PointMonths result;
    result.possibleMin = sun.sunlitMinutes();
    result.sunlitMin.resize(points.size());
    result.longestShadowMin.resize(points.size());
    result.longestSunMin.resize(points.size());
    result.cost.seconds["build"] = build.seconds();
    const Stopwatch watch;
    std::atomic<std::size_t> done{0};
    std::atomic<std::uint64_t> rays{0};
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, points.size(), 4), [&](const auto& range) {
        const FlushDenormals flush;
        for (std::size_t i = range.begin(); i < range.end() && !stop.stop_requested(); ++i)
            rays += tracePoint(trace, points.positions[i], points.normals[i], i, result);
        progress.report(double(done += range.size()) / double(points.size()),
                        NM_TEXT("tracing rays from points"));
    });
    if (stop.stop_requested()) return cancelled();
    result.cost.seconds["trace"] = watch.seconds();
    result.cost.rays = rays;
    result.cost.buildingsUsed = std::uint32_t(city.buildings.size());
    return result;
}

}  // namespace noonmark
