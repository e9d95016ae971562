#include "core/engines/points/horizons/horizon_of_point.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "core/engines/points/sky_obstacles.h"
#include "core/engines/ray/ray_scene.h"
#include "core/engines/ray/surface_rays.h"

namespace noonmark {

namespace {

constexpr std::size_t sunBinCount = SunBins::count;
constexpr float always = BinDirections::always;

}  // namespace

HorizonScene::HorizonScene(const City& city, const SunSteps& sun, bool withTrack)
    : HorizonScene(collectSkyObstacles(city), sun, withTrack) {}

HorizonScene::HorizonScene(const SkyObstacles& obstacles, const SunSteps& sun, bool withTrack)
    : edges(makeEdgeTree(obstacles.edges)), faces(makeFaceTree(obstacles.faces)), suns(sun), bins(suns) {
    if (withTrack) track.emplace(sun);
}

HorizonOfPoint::HorizonOfPoint(const HorizonScene& scene)
    : scene_(scene), firstOf_(sunBinCount + 1), firstJoined_(sunBinCount + 1) {}

namespace {

glm::vec3 eyeAt(glm::vec3 position, glm::vec3 normal) {
    return placeSurfaceRayOrigin(position, normal) +
           glm::vec3(RayScene::wallOffsetM, RayScene::wallOffsetM, 0);
}

}  // namespace

void HorizonOfPoint::sweep(glm::vec3 position, glm::vec3 normal) {
    const glm::vec3 eye = eyeAt(position, normal);
    gaps_.clear();
    faceTowards(normal);
    raiseHorizon(scene_.edges, scene_.bins, eye, horizon_.tan);
    findFaceGaps(scene_.faces, scene_.bins, eye, horizon_.tan, gaps_);
    joinGaps();
}

void HorizonOfPoint::sweepWithBounds(glm::vec3 position, glm::vec3 normal, std::span<const OpenBelow> open) {
    const glm::vec3 eye = eyeAt(position, normal);
    gaps_.clear();
    faceTowards(normal);
    boundFacing(normal);
    raiseHorizonAndBounds(scene_.edges, scene_.bins, eye, horizon_.tan, bounds_.touch.tan, bounds_.cover.tan);
    for (const OpenBelow& one : open) uncover(one, eye);
    findFaceGaps(scene_.faces, scene_.bins, eye, horizon_.tan, gaps_);
    joinGaps();
    if (gaps_.empty()) return bounds_.cover.clearGaps();
    touchGaps();
    coverGaps();
}

void HorizonOfPoint::uncover(const OpenBelow& open, glm::vec3 eye) {
    constexpr double binsPerRad = double(SunBins::count) / (2 * std::numbers::pi);
    const SeenOpenBelow seen = seeFrom(open, {eye, eye});
    if (seen.topTan <= 0) return;
    if (isIn(open, eye)) bounds_.touch.tan.fill(always);
    const int middle = int(std::floor(seen.azimuthRad * binsPerRad)),
              half = std::min(int(seen.halfRad * binsPerRad) + 2, SunBins::count / 2);
    for (int bin = middle - half; bin <= middle + half; ++bin) {
        float& cover = bounds_.cover.tan[std::size_t((bin + 2 * SunBins::count) % SunBins::count)];
        if (double(cover) <= seen.topTan * 1.0001) cover = 0;
    }
}

// What the surface itself hides. The horizon of its plane is a sine, nowhere lower in a bin than at the
// middles beside it, and higher by 2e-6 at most.
void HorizonOfPoint::boundFacing(glm::vec3 normal) {
    constexpr float upright = 1e-7F;
    const auto tanIn = [&](std::size_t bin) {
        const float towards = normal.x * scene_.bins.sine[bin] + normal.y * scene_.bins.cosine[bin];
        if (std::abs(normal.z) < upright) return towards <= 0 ? always : 0.0F;
        return normal.z > 0 ? std::max(0.0F, -towards / normal.z) : 0.0F;
    };
    bounds_.touch.tan.fill(always);
    bounds_.cover.tan.fill(always);
    for (std::size_t bin = 0; bin < sunBinCount; ++bin) {
        if (scene_.bins.highestTan[bin] <= 0) continue;
        const auto [minimum, maximum] = std::minmax(
            {tanIn((bin + sunBinCount - 1) % sunBinCount), tanIn(bin), tanIn((bin + 1) % sunBinCount)});
        constexpr float bent = 1e-5F;
        bounds_.cover.tan[bin] = minimum * (1 - bent);
        bounds_.touch.tan[bin] = normal.z <= -upright ? always : maximum * (1 + bent);
    }
}

// An overhang may reach a bin from the middle of the next one.
void HorizonOfPoint::touchGaps() {
    for (std::size_t bin = 0; bin < sunBinCount; ++bin)
        for (const std::size_t other : {(bin + sunBinCount - 1) % sunBinCount, bin, (bin + 1) % sunBinCount})
            if (scene_.bins.highestTan[other] > 0)
                bounds_.touch.tan[bin] = std::max(bounds_.touch.tan[bin], horizon_.topTan(other));
}

// What overhangs hide at the middle of a bin and at those beside it, they hide between.
void HorizonOfPoint::coverGaps() {
    bounds_.cover.gaps.clear();
    for (std::size_t bin = 0; bin < sunBinCount; ++bin) {
        bounds_.cover.firstGap[bin] = std::uint32_t(bounds_.cover.gaps.size());
        coverGapsOf(bin);
    }
    bounds_.cover.firstGap[sunBinCount] = std::uint32_t(bounds_.cover.gaps.size());
}

void HorizonOfPoint::coverGapsOf(std::size_t bin) {
    const auto before = joinedOf((bin + sunBinCount - 1) % sunBinCount),
               after = joinedOf((bin + 1) % sunBinCount);
    if (before.empty() || after.empty()) return;
    for (const HiddenAltitudes& own : joinedOf(bin))
        for (const HiddenAltitudes& one : before)
            for (const HiddenAltitudes& other : after)
                coverBy(bin, {std::max({own.lowTan, one.lowTan, other.lowTan}),
                              std::min({own.highTan, one.highTan, other.highTan})});
}

void HorizonOfPoint::coverBy(std::size_t bin, const HiddenAltitudes& gap) {
    float& cover = bounds_.cover.tan[bin];
    if (gap.highTan <= std::max(gap.lowTan, double(cover))) return;
    if (gap.lowTan <= double(cover))
        cover = float(gap.highTan);
    else
        bounds_.cover.gaps.push_back(gap);
}

// A bin without suns, or that the surface does not face, is hidden from the beginning.
void HorizonOfPoint::faceTowards(glm::vec3 normal) {
    constexpr float upright = 1e-7F;
    horizon_.tan.fill(always);
    for (std::size_t bin = 0; bin < sunBinCount; ++bin) {
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
    horizon_.clearGaps();
    if (gaps_.empty()) return;
    sortGaps();
    joined_.clear();
    for (std::size_t bin = 0; bin < sunBinCount; ++bin) {
        horizon_.firstGap[bin] = std::uint32_t(horizon_.gaps.size());
        firstJoined_[bin] = std::uint32_t(joined_.size());
        if (firstOf_[bin] < firstOf_[bin + 1]) joinGapsOf(bin);
    }
    horizon_.firstGap[sunBinCount] = std::uint32_t(horizon_.gaps.size());
    firstJoined_[sunBinCount] = std::uint32_t(joined_.size());
}

// Keeps what lies above the horizon. A gap that begins at or below it raises it.
void HorizonOfPoint::joinGapsOf(std::size_t bin) {
    float& horizon = horizon_.tan[bin];
    ofBin_.assign(sorted_.begin() + firstOf_[bin], sorted_.begin() + firstOf_[bin + 1]);
    joinOverlaps(ofBin_);
    joined_.insert(joined_.end(), ofBin_.begin(), ofBin_.end());
    for (const HiddenAltitudes& gap : ofBin_) {
        if (gap.highTan <= double(horizon) || gap.lowTan >= double(scene_.bins.highestTan[bin])) continue;
        if (gap.lowTan > double(horizon))
            horizon_.gaps.push_back(gap);
        else
            horizon = gap.highTan >= double(scene_.bins.highestTan[bin]) ? always : float(gap.highTan);
    }
}

}  // namespace noonmark
