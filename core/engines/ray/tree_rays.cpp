#include "core/engines/ray/tree_rays.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <numeric>
#include <span>
#include <vector>

#include "core/describe/text.h"
#include "core/engines/common/receiver_tiles.h"
#include "core/engines/common/run_counter.h"
#include "core/engines/common/shadow_reach.h"
#include "core/engines/ray/ray_reference.h"
#include "core/engines/trees/crowns_around.h"
#include "core/simd/flush_denormals.h"

namespace noonmark {

namespace {

/// The sun's steps as crowns need them.
struct CrownSun {
    explicit CrownSun(const SunSteps& sun) {
        for (const SunStep& step : sun.steps) {
            const glm::dvec3 direction = glm::normalize(glm::dvec3(step.direction));
            directions.push_back(direction);
            slots.push_back(CrownsAround::slotOf(direction));
            lowestTan = std::min(lowestTan, direction.z / std::hypot(direction.x, direction.y));
        }
    }
    std::vector<glm::dvec3> directions;  // unit vectors, towards the sun
    std::vector<std::uint16_t> slots;    // of azimuth
    double lowestTan = 1e9;
};

/// What crowns add to one receiver's shadow.
struct CrownColumn {
    double added = 0;  // steps, weighted by what is taken from the sun
    RunCounter runs;
    std::uint32_t shaded = 0;  // steps of the current packet, as bits

    void add(int lane, bool blocked, double taken, double shadedFrom) {
        if (!blocked) added += taken;
        if (blocked || taken >= shadedFrom) shaded |= 1U << unsigned(lane);
    }
    void finish(const SunPacket& packet) {
        runs.add(shaded, packet.starts, packet.directions.count);
        shaded = 0;
    }
};

class CrownTracer {
public:
    CrownTracer(const RayScene& scene, const CrownScene& crowns, const Receivers& receivers,
                const SunSteps& sun, TreeShade& shade, Progress& progress, const std::stop_token& stop)
        : scene_(scene),
          crowns_(crowns),
          receivers_(receivers),
          sun_(sun),
          packets_(packSteps(sun)),
          shade_(shade),
          progress_(progress),
          stop_(stop),
          tiles_(receivers) {}

    void run() {
        tbb::parallel_for(tbb::blocked_range<std::size_t>(0, tiles_.count()), [&](const auto& range) {
            const FlushDenormals flush;
            CrownsAround around;
            std::vector<std::uint32_t> cells;
            for (std::size_t tile = range.begin(); tile < range.end() && !stop_.stop_requested(); ++tile)
                traceTile(tile, cells, around);
        });
    }

private:
    void traceTile(std::size_t tile, std::vector<std::uint32_t>& cells, CrownsAround& around) {
        tiles_.cellsOf(tile, cells);
        if (cells.empty()) return;
        const std::vector<std::uint32_t> near = findNear(cells);
        for (const std::uint32_t cell : cells) {
            const glm::vec3 origin = placeRayOrigin(receivers_.position(cell));
            if (!around.gather(crowns_.crowns, near, glm::dvec3(origin), sun_.lowestTan)) continue;
            trace(cell, origin, around);
            if (stop_.stop_requested()) return;
        }
        const std::size_t now = done_.fetch_add(cells.size()) + cells.size();
        progress_.report(double(now) / double(receivers_.cells.size()),
                         NM_TEXT("tracing rays through trees"));
    }

    // The crowns that may shade a cell of a tile.
    [[nodiscard]] std::vector<std::uint32_t> findNear(const std::vector<std::uint32_t>& cells) const {
        std::vector<glm::vec3> places;
        for (const std::uint32_t cell : cells) places.push_back(receivers_.position(cell));
        return findCrownsNear(crowns_.crowns, places, sun_.lowestTan);
    }

    void trace(std::uint32_t cell, glm::vec3 origin, const CrownsAround& around) const {
        constexpr std::size_t packetsBetweenChecks = 1024;
        CrownColumn evergreen, seasonal;
        for (std::size_t i = 0; i < packets_.size(); ++i) {
            if (i % packetsBetweenChecks == 0 && stop_.stop_requested()) return;
            const SunPacket& packet = packets_[i];
            std::uint32_t blocked = 0;
            scene_.blockedLanes({&origin, 1}, packet.directions, {&blocked, 1});
            for (int lane = 0; lane < packet.directions.count; ++lane) {
                const std::size_t step = i * DirectionPacket::capacity + std::size_t(lane);
                addStep(step, lane, (blocked >> unsigned(lane) & 1U) != 0, glm::dvec3(origin), around,
                        evergreen, seasonal);
            }
            evergreen.finish(packet);
            seasonal.finish(packet);
        }
        write(cell, evergreen, *shade_.evergreen);
        write(cell, seasonal, *shade_.seasonal);
    }

    void addStep(std::size_t step, int lane, bool blocked, glm::dvec3 origin, const CrownsAround& around,
                 CrownColumn& evergreen, CrownColumn& seasonal) const {
        CrownDepth depth;
        if (!blocked)
            depth = around.depthAt(sun_.slots[step], crowns_.crowns, origin, sun_.directions[step],
                                   crowns_.phases, crowns_.phases.at(step));
        evergreen.add(lane, blocked, depth.takenShare(true), shade_.shadedFrom);
        seasonal.add(lane, blocked, depth.takenShare(crowns_.inLeaf[step] != 0), shade_.shadedFrom);
    }

    void write(std::uint32_t cell, const CrownColumn& column, ShadowField& field) const {
        field.grossMin[cell] += float(column.added * field.stepMinutes / field.days);
        field.continuousMin[cell] = float(column.runs.longest() * field.stepMinutes);
    }

    const RayScene& scene_;
    const CrownScene& crowns_;
    const Receivers& receivers_;
    const CrownSun sun_;
    const std::vector<SunPacket> packets_;
    TreeShade& shade_;
    Progress& progress_;
    const std::stop_token& stop_;
    ReceiverTiles tiles_;
    std::atomic<std::size_t> done_{0};
};

}  // namespace

Result<TreeShade> traceCrowns(const RayScene& scene, const CrownScene& crowns, const Receivers& receivers,
                              const SunSteps& sun, const ShadowField& without, Progress& progress,
                              const std::stop_token& stop) {
    TreeShade shade = makeTreeShade(without, crowns.crowns.size());
    shade.how = "rays: the exact length of each ray's path through each crown";
    CrownTracer(scene, crowns, receivers, sun, shade, progress, stop).run();
    if (stop.stop_requested()) return cancelled();
    return shade;
}

Result<std::shared_ptr<const TreeShade>> traceTrees(const City& city, const Receivers& receivers,
                                                    const SunSteps& sun, const ShadowField& without,
                                                    Progress& progress, const std::stop_token& stop) {
    const CrownScene crowns = findCrowns(city, receivers, sun);
    if (crowns.empty()) return nullptr;
    const auto scene = RayScene::over(city, findBuildingsInReach(city, receivers, sun), stop);
    if (!scene) return tl::make_unexpected(scene.error());
    auto shade = traceCrowns(*scene, crowns, receivers, sun, without, progress, stop);
    if (!shade) return tl::make_unexpected(shade.error());
    return std::make_shared<const TreeShade>(*std::move(shade));
}

namespace {

// Of a period, from a field that was without shadow.
std::vector<float> minutesOf(const ShadowField& column, const std::vector<std::uint32_t>& cells) {
    std::vector<float> minutes = valuesAt(cells, column.grossMin);
    for (float& one : minutes) one *= float(column.days);
    return minutes;
}

}  // namespace

Result<std::optional<TakenBySet>> traceTreeSets(const City& city, const Receivers& receivers,
                                                const SunSteps& sun, const StepSets& sets, Progress& progress,
                                                const std::stop_token& stop) {
    const CrownScene all = findCrowns(city, receivers, sun);
    if (all.empty()) return std::nullopt;
    const auto scene = RayScene::over(city, findBuildingsInReach(city, receivers, sun), stop);
    if (!scene) return tl::make_unexpected(scene.error());
    TakenBySet taken{.treesUsed = all.crowns.size()};
    for (std::size_t set = 0; set < sets.names.size(); ++set) {
        ProgressShare share(progress, set, sets.names.size());
        const SunSteps own = sets.stepsOf(set, sun);
        const auto shade = traceCrowns(*scene, findCrowns(city, receivers, own), receivers, own,
                                       makeBlankField(receivers, own), share, stop);
        if (!shade) return tl::make_unexpected(shade.error());
        taken.evergreen.push_back(minutesOf(*shade->evergreen, receivers.cells));
        taken.seasonal.push_back(minutesOf(*shade->seasonal, receivers.cells));
        taken.how = shade->how;
    }
    return taken;
}

double countCrownsAtRays(const CrownScene& crowns, const Receivers& receivers, const SunSteps& sun) {
    constexpr std::size_t maximum = 16;  // receivers
    const std::size_t count = std::min(maximum, receivers.cells.size());
    if (count == 0 || sun.steps.empty()) return 0;
    const CrownSun crownSun(sun);
    std::vector<std::uint32_t> all(crowns.crowns.size());
    std::iota(all.begin(), all.end(), 0U);
    CrownsAround around;
    double sum = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const std::uint32_t cell = receivers.cells[i * receivers.cells.size() / count];
        around.gather(crowns.crowns, all, glm::dvec3(receivers.position(cell)), crownSun.lowestTan);
        for (const std::uint16_t slot : crownSun.slots) sum += double(around.at(slot).size());
    }
    return sum / double(count) / double(sun.steps.size());
}

}  // namespace noonmark
