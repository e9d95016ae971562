// The ray reference against a bare Embree loop: same triangles, same flags, same packets, in turn in one run.
// First the answers are compared, then the speeds; the engine must reach 80 % of the bare loop's rays a
// second.
//
//     ray_reference_bench [buildings] [rounds]
#include <embree3/rtcore.h>
#include <fmt/format.h>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <bit>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <numbers>
#include <random>

#include "core/accumulate/flush_denormals.h"
#include "core/accumulate/ray_reference.h"
#include "core/accumulate/ray_scene.h"
#include "core/accumulate/reach.h"
#include "core/accumulate/sun_packets.h"

using namespace noonmark;

namespace {

double secondsOf(const auto& work) {
    const auto start = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// Round towers on a lattice of 24 m, 12 corners each: 44 triangles a building.
City latticeCity(int buildings) {
    std::mt19937 random(1);
    std::exponential_distribution<float> height(1 / 25.0F);
    City city;
    const int side = int(std::ceil(std::sqrt(buildings)));
    for (int i = 0; i < buildings; ++i) {
        const glm::vec2 centre(24.0F * float(i % side - side / 2), 24.0F * float(i / side - side / 2));
        Part part{.bottomM = 0, .topM = 6 + height(random)};
        for (int corner = 0; corner < 12; ++corner) {
            const float angle = float(corner) * std::numbers::pi_v<float> / 6;
            part.footprint.outer.push_back(centre + 9.0F * glm::vec2(std::cos(angle), std::sin(angle)));
        }
        city.buildings.push_back(std::make_shared<const Building>(Building{.parts = {part}}));
    }
    return city;
}

/// Six hours around noon at one minute, near 40 N in March.
SunSteps sixHours() {
    SunSteps sun;
    sun.days.push_back({.first = 0, .count = 360});
    for (int i = 0; i < 360; ++i) {
        const double hour = (i - 180) * std::numbers::pi / 720;
        const double tilt = 41 * std::numbers::pi / 180;
        const glm::dvec3 d{-std::sin(hour), -std::cos(hour) * std::sin(tilt),
                           std::cos(hour) * std::cos(tilt)};
        sun.steps.push_back({.direction = glm::vec3(d), .altitudeDeg = 1, .slot = i});
    }
    return sun;
}

/// What anyone would write first: the same triangles, flags and packets, and nothing else.
class BareLoop {
public:
    BareLoop(const City& city, const Receivers& receivers, const SunSteps& sun)
        : receivers_(receivers), packets_(sunPackets(sun)) {
        City used;
        for (const std::uint32_t i : buildingsInReach(city, receivers, sun))
            used.buildings.push_back(city.buildings[i]);
        const TriangleMesh mesh = meshOf(used).mesh;
        RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
        void* vertices = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 12,
                                                 mesh.vertices.size());
        void* triangles = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 12,
                                                  mesh.triangles.size());
        std::ranges::copy(mesh.vertices, static_cast<glm::vec3*>(vertices));
        std::ranges::copy(mesh.triangles, static_cast<glm::uvec3*>(triangles));
        rtcCommitGeometry(geometry);
        rtcAttachGeometry(scene_, geometry);
        rtcReleaseGeometry(geometry);
        rtcSetSceneFlags(scene_, RTC_SCENE_FLAG_ROBUST);
        rtcCommitScene(scene_);
    }
    BareLoop(const BareLoop&) = delete;
    BareLoop& operator=(const BareLoop&) = delete;
    ~BareLoop() {
        rtcReleaseScene(scene_);
        rtcReleaseDevice(device_);
    }

    /// Rays in shadow.
    std::uint64_t trace() const {
        std::atomic<std::uint64_t> blocked{0};
        tbb::parallel_for(tbb::blocked_range<std::size_t>(0, receivers_.cells.size(), 64),
                          [&](const auto& range) {
                              const FlushDenormals flush;
                              std::uint64_t mine = 0;
                              for (std::size_t i = range.begin(); i < range.end(); ++i)
                                  mine += blockedAt(rayOrigin(receivers_.position(receivers_.cells[i])));
                              blocked += mine;
                          });
        return blocked;
    }

private:
    std::uint64_t blockedAt(glm::vec3 origin) const {
        std::uint64_t blocked = 0;
        RTCIntersectContext context;
        rtcInitIntersectContext(&context);
        context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
        for (const SunPacket& packet : packets_) {
            RTCRay16 rays;
            alignas(64) int valid[16];
            for (int lane = 0; lane < 16; ++lane) {
                rays.org_x[lane] = origin.x, rays.org_y[lane] = origin.y, rays.org_z[lane] = origin.z;
                rays.dir_x[lane] = packet.directions.x[std::size_t(lane)];
                rays.dir_y[lane] = packet.directions.y[std::size_t(lane)];
                rays.dir_z[lane] = packet.directions.z[std::size_t(lane)];
                rays.tnear[lane] = RayScene::nearestM,
                rays.tfar[lane] = std::numeric_limits<float>::infinity();
                rays.time[lane] = 0, rays.mask[lane] = ~0U, rays.id[lane] = 0, rays.flags[lane] = 0;
                valid[lane] = lane < packet.directions.count ? -1 : 0;
            }
            rtcOccluded16(valid, scene_, &context, &rays);
            for (int lane = 0; lane < 16; ++lane) blocked += rays.tfar[lane] < 0;
        }
        return blocked;
    }

    const Receivers& receivers_;
    std::vector<SunPacket> packets_;
    RTCDevice device_ = rtcNewDevice(nullptr);
    RTCScene scene_ = rtcNewScene(device_);
};

std::uint64_t blockedIn(const ShadowField& field) {
    double minutes = 0;
    for (const float gross : field.grossMin) minutes += std::isnan(gross) ? 0 : double(gross);
    return std::uint64_t(std::llround(minutes));
}

}  // namespace

int main(int argc, char** argv) {
    const int buildings = argc > 1 ? std::atoi(argv[1]) : 34000;
    const int rounds = argc > 2 ? std::atoi(argv[2]) : 5;
    const City city = latticeCity(buildings);
    const Receivers receivers =
        receiversOnGround(city, regionFromLocalBox({{-400, -400}, {400, 400}}), {2}).value();
    const SunSteps sun = sixHours();
    const BareLoop bare(city, receivers, sun);
    const RayReference engine;
    NoProgress progress;

    double bareBest = 1e9, engineBest = 1e9;
    std::uint64_t rays = 0;
    for (int round = 0; round < rounds; ++round) {
        std::uint64_t expected = 0;
        bareBest = std::min(bareBest, secondsOf([&] { expected = bare.trace(); }));
        const ShadowField field = engine.accumulate(city, receivers, sun, progress, {}).value();
        engineBest = std::min(engineBest, field.cost.seconds.at("trace"));
        rays = field.cost.rays;
        if (blockedIn(field) != expected) {
            fmt::print("the answers differ: {} rays in shadow, the bare loop has {}\n", blockedIn(field),
                       expected);
            return EXIT_FAILURE;
        }
        if (round == 0)
            fmt::print(
                "{} buildings ({} in reach), {} receivers, {} steps, {:.1f} % of rays in shadow, build "
                "{:.2f} s\n",
                buildings, field.cost.buildingsUsed, receivers.cells.size(), sun.steps.size(),
                100 * double(expected) / double(rays), field.cost.seconds.at("build"));
    }
    const double share = bareBest / engineBest;
    fmt::print("bare Embree loop {:.1f} M rays/s, ray reference {:.1f} M rays/s: {:.0f} %\n",
               double(rays) / bareBest * 1e-6, double(rays) / engineBest * 1e-6, 100 * share);
    return share >= 0.8 ? EXIT_SUCCESS : EXIT_FAILURE;
}
