// The ray reference against a bare Embree loop with the same triangles, flags and packets, in alternating
// runs. First the results are compared, then the speeds; the engine must reach 80 % of the bare loop's rays
// per second.
//
//     ray_reference_bench [FILE or number of buildings] [rounds]
#include <embree3/rtcore.h>
#include <fmt/format.h>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <numbers>

#include "core/engines/common/shadow_reach.h"
#include "core/engines/common/sun_packets.h"
#include "core/engines/ray/ray_reference.h"
#include "core/engines/ray/ray_scene.h"
#include "core/simd/flush_denormals.h"
#include "tests/benchmarks/bench_scene.h"

using namespace noonmark;
using namespace noonmark::bench;

namespace {

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

/// The most direct implementation: the same triangles, flags and packets, and nothing else.
class BareLoop {
public:
    BareLoop(const City& city, const Receivers& receivers, const SunSteps& sun)
        : receivers_(receivers), packets_(packSteps(sun)) {
        City used;
        for (const std::uint32_t i : findBuildingsInReach(city, receivers, sun))
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

    /// Number of rays in shadow.
    std::uint64_t trace() const {
        std::atomic<std::uint64_t> blocked{0};
        tbb::parallel_for(tbb::blocked_range<std::size_t>(0, receivers_.cells.size(), 64),
                          [&](const auto& range) {
                              const FlushDenormals flush;
                              std::uint64_t mine = 0;
                              for (std::size_t i = range.begin(); i < range.end(); ++i)
                                  mine += blockedAt(placeRayOrigin(receivers_.position(receivers_.cells[i])));
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

/// The best times so far. The engine's wall time is that of its stage "trace"; its processor time includes
/// building the tree.
struct Best {
    Seconds bare;
    Seconds engine;
};

/// Runs both once; false if they disagree on the number of rays in shadow.
bool race(const BareLoop& bare, const City& city, const Receivers& receivers, const SunSteps& sun,
          Best& best) {
    std::uint64_t expected = 0;
    best.bare.keepBest(secondsOf([&] { expected = bare.trace(); }));
    NoProgress progress;
    ShadowField field;
    Seconds seconds =
        secondsOf([&] { field = RayReference().accumulate(city, receivers, sun, progress, {}).value(); });
    seconds.wall = field.cost.seconds.at("trace");
    best.engine.keepBest(seconds);
    const std::uint64_t blocked = blockedIn(field);
    const double share = double(blocked) / double(field.cost.rays);
    fmt::print("{} of {} buildings in reach, build {:.2f} s, {} rays, {:.1f} % in shadow\n",
               field.cost.buildingsUsed, city.buildings.size(), field.cost.seconds.at("build"),
               field.cost.rays, 100 * share);
    if (blocked != expected)
        fmt::print("the answers differ: {} rays in shadow, the bare loop has {}\n", blocked, expected);
    return blocked == expected;
}

}  // namespace

int main(int argc, char** argv) {
    const City city = cityFrom(argc > 1 ? argv[1] : "43000");
    const int rounds = argc > 2 ? std::stoi(argv[2]) : 5;
    const Receivers receivers = placeReceiversOnGround(city, findMiddle(city), {2}).value();
    const SunSteps sun = sixHours();
    const BareLoop bare(city, receivers, sun);
    Best best;
    for (int round = 0; round < rounds; ++round)
        if (!race(bare, city, receivers, sun, best)) return EXIT_FAILURE;
    const double mega = double(receivers.cells.size() * sun.steps.size()) * 1e-6;
    const double share = best.bare.wall / best.engine.wall;
    fmt::print("bare Embree loop {:.1f} M rays/s, ray reference {:.1f} M rays/s: {:.0f} %\n",
               mega / best.bare.wall, mega / best.engine.wall, 100 * share);
    fmt::print("a second of one core: {:.1f} M rays, {:.1f} M rays (the tree built too)\n",
               mega / best.bare.processor, mega / best.engine.processor);
    return share >= 0.8 ? EXIT_SUCCESS : EXIT_FAILURE;
}
