#include "core/engines/points/horizon_of_point.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/engines/points/sky_trees.h"
#include "core/engines/ray/ray_scene.h"
#include "core/engines/ray/surface_rays.h"

namespace noonmark {

namespace {

constexpr int binCount = SunBins::count;
constexpr float always = std::numeric_limits<float>::infinity();
constexpr double binWidth = fullTurn / binCount;

}  // namespace

HorizonScene::HorizonScene(const City& city, const SunSteps& sun, bool withTrack)
    : obstacles(collectSkyObstacles(city)),
      edges(findBoxes(obstacles.edges)),
      faces(findBoxes(obstacles.faces)),
      suns(sun) {
    if (withTrack) track.emplace(sun);
    for (int bin = 0; bin < binCount; ++bin) {
        sine[std::size_t(bin)] = float(std::sin((bin + 0.5) * binWidth));
        cosine[std::size_t(bin)] = float(std::cos((bin + 0.5) * binWidth));
    }
}

void HorizonOfPoint::sweep(glm::vec3 position, glm::vec3 normal) {
    eye_ = placeSurfaceRayOrigin(position, normal) + glm::vec3(RayScene::asideM, RayScene::asideM, 0);
    gaps_.clear();
    faceTowards(normal);
    const auto canMatter = [this](const ObstacleBox& box) { return risesAbove(box); };
    scene_.edges.visitNearestFirst(eye_, canMatter,
                                   [this](std::uint32_t index) { raise(scene_.obstacles.edges[index]); });
    scene_.faces.visitNearestFirst(eye_, canMatter,
                                   [this](std::uint32_t index) { addGaps(scene_.obstacles.faces[index]); });
    joinGaps();
}

// A bin without suns, or that the surface does not face, is hidden from the beginning.
void HorizonOfPoint::faceTowards(glm::vec3 normal) {
    constexpr float upright = 1e-7F;
    for (int bin = 0; bin < binCount; ++bin) {
        const auto k = std::size_t(bin);
        const float towards = normal.x * scene_.sine[k] + normal.y * scene_.cosine[k];
        horizon_.tan[k] = 0;
        if (scene_.suns.empty(bin) || (std::abs(normal.z) < upright && towards <= 0))
            horizon_.tan[k] = always;
        else if (normal.z >= upright)
            setHorizon(bin, -towards / normal.z);
        else if (normal.z <= -upright)
            gaps_.push_back({bin, {std::max(0.0, double(towards / -normal.z)), double(always)}});
    }
}

void HorizonOfPoint::setHorizon(int bin, float tan) {
    float& horizon = horizon_.tan[std::size_t(bin)];
    if (tan <= horizon) return;
    horizon = tan >= scene_.suns.highestTan(bin) ? always : tan;
}

bool HorizonOfPoint::anyBelow(Bins bins, float tan) const {
    for (int bin = bins.first; bin <= bins.last; ++bin)
        if (horizon_.tan[std::size_t(bin >= binCount ? bin - binCount : bin)] < tan) return true;
    return false;
}

// The azimuths of a circle around the box.
bool HorizonOfPoint::risesAbove(const ObstacleBox& box) const {
    const float height = box.high.z - eye_.z;
    if (height <= 0) return false;
    const glm::vec3 middle = box.middle() - eye_;
    const float distance = std::hypot(middle.x, middle.y);
    const float radius = 0.5F * std::hypot(box.high.x - box.low.x, box.high.y - box.low.y);
    if (distance <= radius * 1.001F) return anyBelow({0, binCount - 1}, always);
    const double half = std::asin(std::min(1.0, double(radius) * 1.001 / double(distance))) + binWidth;
    double from = azimuthOf({double(middle.x), double(middle.y), 0.0}) - half;
    if (from < 0) from += fullTurn;
    const int first = int(from / binWidth);
    const int last = std::min(first + binCount - 1, int((from + 2 * half) / binWidth));
    const float near = std::sqrt(ObstacleTree::distance2(box, eye_));
    return anyBelow({first, last}, near > 0 ? height / near * 1.0001F : always);
}

// The bins whose middle lies between two azimuths.
HorizonOfPoint::Bins HorizonOfPoint::binsBetween(double from, double to) {
    return {int(std::ceil(from / binWidth - 0.5)), int(std::floor(to / binWidth - 0.5))};
}

void HorizonOfPoint::raise(const TopEdge& edge) {
    const auto seen = seeEdge(edge, glm::dvec3(eye_));
    if (!seen) return;
    const Bins bins = binsBetween(seen->from, seen->to);
    const auto east = float(seen->east), north = float(seen->north);
    for (int i = bins.first; i <= bins.last; ++i) {
        const int bin = i >= binCount ? i - binCount : i;
        const auto k = std::size_t(bin);
        if (horizon_.tan[k] < always) setHorizon(bin, east * scene_.sine[k] + north * scene_.cosine[k]);
    }
}

void HorizonOfPoint::addGaps(const OverhangFace& face) {
    const glm::dvec3 eye(eye_);
    const double start = azimuthOf(glm::dvec3(face.corners[0]) - eye);
    double low = 0, high = 0;
    for (std::size_t i = 1; i < 3; ++i) {
        const double turn = std::remainder(azimuthOf(glm::dvec3(face.corners[i]) - eye) - start, fullTurn);
        low = std::min(low, turn), high = std::max(high, turn);
    }
    const bool around = high - low >= std::numbers::pi;  // above or below the point
    const Bins bins = around ? Bins{0, binCount - 1} : binsBetween(start + low, start + high);
    for (int i = bins.first; i <= bins.last; ++i) addGap(face, (i + binCount) % binCount);
}

void HorizonOfPoint::addGap(const OverhangFace& face, int bin) {
    const float horizon = horizon_.tan[std::size_t(bin)];
    if (horizon == always) return;
    const auto hidden = hiddenBy(face, glm::dvec3(eye_), (bin + 0.5) * binWidth);
    if (!hidden || hidden->highTan <= double(horizon)) return;
    gaps_.push_back({bin, *hidden});
}

// Only what lies above the horizon; sorted by bin.
void HorizonOfPoint::joinGaps() {
    horizon_.gaps.clear();
    std::ranges::sort(gaps_, {}, &BinGap::bin);
    auto gap = gaps_.begin();
    for (int bin = 0; bin < binCount; ++bin) {
        horizon_.firstGap[std::size_t(bin)] = std::uint32_t(horizon_.gaps.size());
        joined_.clear();
        for (; gap != gaps_.end() && gap->bin == bin; ++gap)
            if (gap->hidden.highTan > double(horizon_.tan[std::size_t(bin)])) joined_.push_back(gap->hidden);
        if (joined_.empty()) continue;
        joinOverlaps(joined_);
        horizon_.gaps.insert(horizon_.gaps.end(), joined_.begin(), joined_.end());
    }
    horizon_.firstGap[binCount] = std::uint32_t(horizon_.gaps.size());
}

SunBins::Months HorizonOfPoint::countSunlit() const {
    SunBins::Months months{};
    for (int bin = 0; bin < binCount; ++bin) {
        const auto k = std::size_t(bin);
        if (horizon_.tan[k] == always) continue;
        scene_.suns.addAll(bin, months);
        if (horizon_.tan[k] > 0) scene_.suns.addUpTo(bin, horizon_.tan[k], true, -1, months);
        for (std::uint32_t i = horizon_.firstGap[k]; i < horizon_.firstGap[k + 1]; ++i)
            subtractGap(bin, horizon_.gaps[i], months);
    }
    return months;
}

// Only what lies above the horizon, which was subtracted already.
void HorizonOfPoint::subtractGap(int bin, const HiddenAltitudes& hidden, SunBins::Months& months) const {
    const float horizon = horizon_.tan[std::size_t(bin)];
    scene_.suns.addUpTo(bin, float(hidden.highTan), true, -1, months);
    if (hidden.lowTan > double(horizon))
        scene_.suns.addUpTo(bin, float(hidden.lowTan), false, 1, months);
    else if (horizon > 0)
        scene_.suns.addUpTo(bin, horizon, true, 1, months);
}

}  // namespace noonmark
