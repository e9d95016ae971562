#include "core/engines/points/horizons/point_runs.h"

#include <algorithm>
#include <bit>
#include <glm/geometric.hpp>

#include "core/engines/ray/surface_rays.h"

namespace noonmark {

PointRunRays::PointRunRays(const RayScene& scene, const SunSteps& sun, glm::vec3 position, glm::vec3 normal)
    : scene_(scene), sun_(sun), origin_(placeSurfaceRayOrigin(position, normal)), normal_(normal) {}

std::uint32_t PointRunRays::findShaded(std::span<const std::uint32_t> steps) const {
    if (steps.size() == 1) return isShaded(sun_.steps[steps[0]].direction) ? 1 : 0;
    DirectionPacket packet{.count = int(steps.size())};
    std::uint32_t away = 0;
    for (std::size_t lane = 0; lane < together; ++lane) {
        const glm::vec3 sun = sun_.steps[steps[std::min(lane, steps.size() - 1)]].direction;
        packet.x[lane] = sun.x;
        packet.y[lane] = sun.y;
        packet.z[lane] = sun.z;
        if (normal_.x * sun.x + normal_.y * sun.y + normal_.z * sun.z <= 0) away |= 1U << lane;
    }
    std::uint32_t blocked = 0;
    scene_.blockedLanes({&origin_, 1}, packet, {&blocked, 1});
    rays_ += steps.size();
    return (blocked | away) & std::uint32_t((1ULL << steps.size()) - 1);
}

bool PointRunRays::isShaded(glm::vec3 sun) const {
    if (normal_.x * sun.x + normal_.y * sun.y + normal_.z * sun.z <= 0) return true;
    ++rays_;
    return scene_.occluded(origin_, sun);
}

namespace {

constexpr std::size_t together = PointRunRays::together;
// The first asks mostly find an end, so they are about few steps.
constexpr std::array<std::size_t, 3> askedFirst{1, 1, 4};

}  // namespace

PointRuns PointRunSearch::decide(const BinHorizon& horizon, const HorizonBounds& bounds,
                                 const PointRunRays& rays) {
    const Point point{horizon, bounds, rays};
    const SunTrack::Longest found = track_.findLongest(horizon);
    ofShadow_ = true;
    const std::uint32_t shadow = longest(found.shadow, point);
    ofShadow_ = false;
    return {shadow, longest(found.sun, point)};
}

std::uint32_t PointRunSearch::longest(const TrackRun& found, const Point& point) {
    isEndBin_.fill(0);
    findDoubts(found, point);
    const bool confirmed = holds(found, point.rays);
    longest_ = confirmed ? found.length() : 0;
    const std::uint32_t spare = confirmed ? std::uint32_t(allowed) : 0;
    const BinHorizon& maximum = ofShadow_ ? point.bounds.touch : point.bounds.cover;
    for (const TrackRun& run : track_.findRuns(maximum, ofShadow_, longest_ + spare)) {
        if (run.length() <= longest_ + spare) break;
        findDoubts(run, point);
        search(run, point.rays);
    }
    return longest_;
}

void PointRunSearch::findDoubts(const TrackRun& run, const Point& point) {
    doubts_.clear();
    for (std::uint32_t step = run.first; step < run.end; ++step) {
        const bool surely =
            ofShadow_ ? track_.hides(point.bounds.cover, step) : !track_.hides(point.bounds.touch, step);
        if (!surely)
            doubts_.push_back({step, track_.binOf(step), track_.hides(point.horizon, step) != ofShadow_});
    }
}

// Bit k: doubt k ends a run.
std::uint32_t PointRunSearch::findEnds(std::span<Doubt* const> doubts, const PointRunRays& rays) const {
    std::array<std::uint32_t, together> steps;
    std::ranges::transform(doubts, steps.begin(), &Doubt::step);
    const std::uint32_t shaded = rays.findShaded(std::span(steps).first(doubts.size()));
    return (ofShadow_ ? ~shaded : shaded) & std::uint32_t((1ULL << doubts.size()) - 1);
}

// Whether the run is unbroken except for the number of steps that it may be off.
bool PointRunSearch::holds(const TrackRun& run, const PointRunRays& rays) {
    TrackRun rest = run;
    std::uint32_t unbroken = 0;
    for (std::size_t first = 0; first < doubts_.size(); first += together) {
        asked_.clear();
        for (std::size_t i = first; i < std::min(doubts_.size(), first + together); ++i)
            asked_.push_back(&doubts_[i]);
        for (std::uint32_t ends = findEnds(asked_, rays); ends != 0; ends &= ends - 1) {
            const std::uint32_t step = asked_[std::size_t(std::countr_zero(ends))]->step;
            unbroken = std::max(unbroken, step - rest.first);
            rest.first = step + 1;
        }
        if (std::max(unbroken, rest.length()) + allowed < run.length()) return false;
    }
    return true;
}

// Raises longest_ to that of the steps of a run that may be unbroken.
void PointRunSearch::search(TrackRun run, const PointRunRays& rays) {
    while (run.length() > longest_) {
        const auto end = findEnd(run, rays);
        if (!end) {
            longest_ = run.length();
            return;
        }
        search({run.first, *end}, rays);
        run.first = *end + 1;
    }
}

// Looks for a step that ends the run: first where another day ended, then where the horizon says so, then
// everywhere.
std::optional<std::uint32_t> PointRunSearch::findEnd(const TrackRun& run, const PointRunRays& rays) {
    const auto from = std::ranges::lower_bound(doubts_, run.first, {}, &Doubt::step),
               to = std::ranges::lower_bound(from, doubts_.end(), run.end, {}, &Doubt::step);
    const std::uint32_t middle = run.first + run.length() / 2;
    for (const Which which : {Which::inEndBins, Which::likelyEnds, Which::all})
        if (const auto end = findEndAmong({from, to}, middle, which, rays)) return end;
    return std::nullopt;
}

bool PointRunSearch::isWanted(const Doubt& doubt, Which which) const {
    if (doubt.isWithin) return false;
    if (which == Which::inEndBins) return isEndBin_[doubt.bin] != 0;
    return which == Which::all || doubt.isLikelyEnd;
}

// From the middle of the run outwards, since an end there leaves two runs too short to matter.
std::optional<std::uint32_t> PointRunSearch::findEndAmong(std::span<Doubt> doubts, std::uint32_t middle,
                                                          Which which, const PointRunRays& rays) {
    auto after = std::ranges::upper_bound(doubts, middle, {}, &Doubt::step), before = after;
    std::size_t asks = 0;
    asked_.clear();
    while (before != doubts.begin() || after != doubts.end()) {
        const bool isBefore =
            after == doubts.end() ||
            (before != doubts.begin() && middle - std::prev(before)->step <= after->step - middle);
        Doubt& doubt = isBefore ? *--before : *after++;
        if (isWanted(doubt, which)) asked_.push_back(&doubt);
        const std::size_t maximum = asks < askedFirst.size() ? askedFirst[asks] : together;
        const bool isLast = before == doubts.begin() && after == doubts.end();
        if (asked_.empty() || (asked_.size() < maximum && !isLast)) continue;
        const std::uint32_t ends = findEnds(asked_, rays);
        for (std::size_t i = 0; i < asked_.size(); ++i) asked_[i]->isWithin = (ends >> i & 1U) == 0;
        if (ends != 0) {
            const Doubt& end = *asked_[std::size_t(std::countr_zero(ends))];
            isEndBin_[end.bin] = 1;
            return end.step;
        }
        asked_.clear();
        ++asks;
    }
    return std::nullopt;
}

}  // namespace noonmark
