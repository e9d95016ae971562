#include "core/engines/ray/surface_rays.h"

#include <fmt/format.h>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <algorithm>
#include <atomic>
#include <glm/geometric.hpp>

#include "core/base/memory_guard.h"
#include "core/describe/text.h"
#include "core/engines/common/run_counter.h"
#include "core/engines/ray/ray_reference.h"
#include "core/simd/flush_denormals.h"

namespace noonmark {

namespace {

RunCounter runsAt(const RayScene& scene, glm::vec3 place, const std::vector<SunPacket>& packets,
                  const std::stop_token& stop) {
    constexpr std::size_t packetsBetweenChecks = 1024;  // some milliseconds
    const FlushDenormals flush;
    const glm::vec3 origin = placeRayOrigin(place);
    RunCounter runs;
    for (std::size_t i = 0; i < packets.size(); ++i) {
        if (i % packetsBetweenChecks == 0 && stop.stop_requested()) break;
        std::uint32_t blocked = 0;
        scene.blockedLanes({&origin, 1}, packets[i].directions, {&blocked, 1});
        runs.add(blocked, packets[i].starts, packets[i].directions.count);
    }
    return runs;
}

}  // namespace

Result<std::vector<PointMinutes>> traceMinutesAt(const RayScene& scene, std::span<const glm::vec3> places,
                                                 const SunSteps& sun, Progress& progress,
                                                 const std::stop_token& stop) {
    const std::vector<SunPacket> packets = packSteps(sun);
    const double days = std::max(1.0, double(sun.dayCount()));
    std::vector<PointMinutes> minutes(places.size());
    std::atomic<std::size_t> done{0};
    tbb::parallel_for(std::size_t{0}, places.size(), [&](std::size_t i) {
        const RunCounter runs = runsAt(scene, places[i], packets, stop);
        minutes[i] = {runs.total() * sun.stepMinutes / days, runs.longest() * sun.stepMinutes};
        progress.report(double(++done) / double(places.size()), NM_TEXT("tracing rays"));
    });
    if (stop.stop_requested()) return cancelled();
    return minutes;
}

namespace {

// Bit k: the surface faces the sun in lane k.
std::uint32_t facing(glm::vec3 normal, const DirectionPacket& sun) {
    std::uint32_t lanes = 0;
    for (int lane = 0; lane < sun.count; ++lane) {
        const auto k = std::size_t(lane);
        if (normal.x * sun.x[k] + normal.y * sun.y[k] + normal.z * sun.z[k] > 0)
            lanes |= 1U << unsigned(lane);
    }
    return lanes;
}

class SurfaceTracer {
public:
    SurfaceTracer(const RayScene& scene, const SurfacePoints& points, const SunSteps& sun,
                  SurfaceShadow& shadow, Progress& progress, const std::stop_token& stop)
        : scene_(scene),
          points_(points),
          packets_(packSteps(sun)),
          days_(std::max(1.0, double(sun.dayCount()))),
          stepMinutes_(sun.stepMinutes),
          shadow_(shadow),
          progress_(progress),
          stop_(stop) {}

    void run() {
        tbb::parallel_for(tbb::blocked_range<std::size_t>(0, points_.size(), 64), [&](const auto& range) {
            const FlushDenormals flush;
            for (std::size_t i = range.begin(); i < range.end() && !stop_.stop_requested(); ++i) trace(i);
            report(range.size());
        });
    }

    [[nodiscard]] std::uint64_t turnedAway() const { return turnedAway_; }

private:
    void trace(std::size_t point) {
        const glm::vec3 normal = points_.normals[point];
        const glm::vec3 origin = placeSurfaceRayOrigin(points_.positions[point], normal);
        RunCounter runs;
        std::uint64_t turnedAway = 0;
        for (const SunPacket& packet : packets_) {
            const std::uint32_t lit = facing(normal, packet.directions);
            const std::uint32_t away = ~lit & std::uint32_t((1ULL << unsigned(packet.directions.count)) - 1);
            std::uint32_t blocked = 0;
            if (lit != 0)
                scene_.blockedLanes({&origin, 1}, packet.directions, {&blocked, 1});
            else
                turnedAway += std::uint64_t(packet.directions.count);
            runs.add(blocked | away, packet.starts, packet.directions.count);
        }
        shadow_.grossMin[point] = float(runs.total() * stepMinutes_ / days_);
        shadow_.continuousMin[point] = float(runs.longest() * stepMinutes_);
        turnedAway_ += turnedAway;
    }

    void report(std::size_t points) {
        const std::size_t now = done_.fetch_add(points) + points;
        if (now * 200 / points_.size() != (now - points) * 200 / points_.size())
            progress_.report(double(now) / double(points_.size()), NM_TEXT("tracing rays"));
    }

    const RayScene& scene_;
    const SurfacePoints& points_;
    std::vector<SunPacket> packets_;
    double days_;
    double stepMinutes_;
    SurfaceShadow& shadow_;
    Progress& progress_;
    const std::stop_token& stop_;
    std::atomic<std::size_t> done_{0};
    std::atomic<std::uint64_t> turnedAway_{0};
};

Result<SurfaceShadow> tracePoints(const City& city, const std::optional<RayScene>& ready,
                                  const SurfacePoints& points, const SunSteps& sun, Progress& progress,
                                  const std::stop_token& stop) {
    auto shadow = makeBlankSurfaceShadow(points, sun);
    if (!shadow) return shadow;
    progress.report(0, NM_TEXT("building the ray scene"));
    const Stopwatch build;
    const auto scene = ready ? Result<RayScene>(*ready) : RayScene::over(city, stop);
    if (!scene) return tl::make_unexpected(scene.error());
    shadow->cost.seconds["build"] = build.seconds();
    const Stopwatch trace;
    SurfaceTracer tracer(*scene, points, sun, *shadow, progress, stop);
    tracer.run();
    if (stop.stop_requested()) return cancelled();
    shadow->cost.seconds["trace"] = trace.seconds();
    shadow->cost.buildingsUsed = std::uint32_t(city.buildings.size());
    shadow->cost.skipped["rays from surfaces turned away from the sun"] = tracer.turnedAway();
    shadow->cost.rays = std::uint64_t(points.size()) * sun.steps.size() - tracer.turnedAway();
    shadow->engine = fmt::format("Ray reference on surfaces, {}, robust", RayScene::backend());
    return shadow;
}

}  // namespace

glm::vec3 placeSurfaceRayOrigin(glm::vec3 position, glm::vec3 normal) {
    return placeRayOrigin(position) + normal * SurfaceRays::liftM;
}

SurfaceRays::SurfaceRays(std::optional<RayScene> scene) : scene_(std::move(scene)) {}

Result<SurfaceShadow> SurfaceRays::accumulate(const City& city, const SurfacePoints& points,
                                              const SunSteps& sun, Progress& progress,
                                              std::stop_token stop) const {
    return guardMemory({"this view", "ray reference", "Choose a smaller view"},
                       [&] { return tracePoints(city, scene_, points, sun, progress, stop); });
}

}  // namespace noonmark
