#include "core/engines/points/horizons/horizon_of_point.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/engines/points/horizons/raise_horizon.h"
#include "core/engines/points/sky_obstacles.h"
#include "core/engines/ray/ray_scene.h"
#include "core/engines/ray/surface_rays.h"

namespace noonmark {

namespace {

constexpr std::size_t binCount = SunBins::count;
constexpr float always = BinDirections::always;

}  // namespace

HorizonScene::HorizonScene(const City& city, const SunSteps& sun, bool withTrack)
    : HorizonScene(collectSkyObstacles(city), sun, withTrack) {}

HorizonScene::HorizonScene(const SkyObstacles& obstacles, const SunSteps& sun, bool withTrack)
    : edges(makeEdgeTree(obstacles.edges)), faces(makeFaceTree(obstacles.faces)), suns(sun), bins(suns) {
    if (withTrack) track.emplace(sun);
}

HorizonOfPoint::HorizonOfPoint(const HorizonScene& scene) : scene_(scene), firstOf_(binCount + 1) {}

void HorizonOfPoint::sweep(glm::vec3 position, glm::vec3 normal) {
    const glm::vec3 eye =
        placeSurfaceRayOrigin(position, normal) + glm::vec3(RayScene::asideM, RayScene::asideM, 0);
    gaps_.clear();
    faceTowards(normal);
    raiseHorizon(scene_.edges, scene_.bins, eye, horizon_.tan);
    findFaceGaps(scene_.faces, scene_.bins, eye, horizon_.tan, gaps_);
    joinGaps();
}

// A bin without suns, or that the surface does not face, is hidden from the beginning.
void HorizonOfPoint::faceTowards(glm::vec3 normal) {
    constexpr float upright = 1e-7F;
    horizon_.tan.fill(always);
    for (std::size_t bin = 0; bin < binCount; ++bin) {
        const float towards = normal.x * scene_.bins.sine[bin] + normal.y * scene_.bins.cosine[bin];
        const float highest = scene_.bins.highestTan[bin];
        if (highest <= 0 || (std::abs(normal.z) < upright && towards <= 0)) continue;
        const float own = normal.z >= upright ? std::max(0.0F, -towards / normal.z) : 0;
        horizon_.tan[bin] = own > 0 && own >= highest ? always : own;
        if (normal.z <= -upright) gaps_.push_back({int(bin), std::max(0.0F, towards / -normal.z), always});
    }
}

// Each bin's gaps one after the other, by counting.
void HorizonOfPoint::sortGaps() {
    std::ranges::fill(firstOf_, 0U);
    for (const BinGap& gap : gaps_) ++firstOf_[std::size_t(gap.bin)];
    std::exclusive_scan(firstOf_.begin(), firstOf_.end(), firstOf_.begin(), 0U);
    sorted_.resize(gaps_.size());
    for (const BinGap& gap : gaps_)
        sorted_[firstOf_[std::size_t(gap.bin)]++] = {double(gap.lowTan), double(gap.highTan)};
    std::shift_right(firstOf_.begin(), firstOf_.end(), 1);
    firstOf_.front() = 0;
}

void HorizonOfPoint::joinGaps() {
    horizon_.gaps.clear();
    if (gaps_.empty()) return horizon_.firstGap.fill(0);
    sortGaps();
    for (std::size_t bin = 0; bin < binCount; ++bin) {
        horizon_.firstGap[bin] = std::uint32_t(horizon_.gaps.size());
        if (firstOf_[bin] < firstOf_[bin + 1]) joinGapsOf(bin);
    }
    horizon_.firstGap[binCount] = std::uint32_t(horizon_.gaps.size());
}

// Keeps what lies above the horizon. A gap that begins at or below it raises it.
void HorizonOfPoint::joinGapsOf(std::size_t bin) {
    float& horizon = horizon_.tan[bin];
    joined_.assign(sorted_.begin() + firstOf_[bin], sorted_.begin() + firstOf_[bin + 1]);
    joinOverlaps(joined_);
    for (const HiddenAltitudes& gap : joined_) {
        if (gap.highTan <= double(horizon) || gap.lowTan >= double(scene_.bins.highestTan[bin])) continue;
        if (gap.lowTan > double(horizon))
            horizon_.gaps.push_back(gap);
        else
            horizon = gap.highTan >= double(scene_.bins.highestTan[bin]) ? always : float(gap.highTan);
    }
}

}  // namespace noonmark
