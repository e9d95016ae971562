#include "core/engines/ray/ray_minutes.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>

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
        progress.report(double(++done) / double(places.size()), "tracing rays");
    });
    if (stop.stop_requested()) return cancelled();
    return minutes;
}

}  // namespace noonmark
