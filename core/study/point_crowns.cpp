#include "core/study/point_crowns.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <numbers>
#include <numeric>

#include "core/engines/common/shadow_reach.h"
#include "core/engines/ray/surface_rays.h"
#include "core/engines/ray/tree_rays.h"
#include "core/engines/shade_trees.h"
#include "core/engines/trees/crowns.h"
#include "core/engines/trees/crowns_around.h"

namespace noonmark {

namespace {

// The sun's own width: a crown that rises less above the skyline is not seen.
constexpr double smallestDeg = 0.5;
constexpr double columnDeg = 5;
constexpr int minColumns = 9;

double degrees(double radians) { return Radians{radians}.degrees().value; }

/// The altitudes at which one crown is met from a place, by the chords that rays have in it.
class CrownView {
public:
    CrownView(const Crown& crown, glm::dvec3 eye)
        : crown_(crown),
          eye_(eye),
          distance_(std::hypot(crown.x - eye.x, crown.y - eye.y)),
          isAround_(distance_ <= crown.radiusM) {}

    [[nodiscard]] double distanceM() const { return distance_; }
    /// The eye is below or inside the crown, which is then seen at all azimuths.
    [[nodiscard]] bool isAround() const { return isAround_; }
    /// Azimuth of its axis and half of its width, radians in the frame.
    [[nodiscard]] double azimuth() const { return std::atan2(crown_.x - eye_.x, crown_.y - eye_.y); }
    [[nodiscard]] double halfWidth() const {
        return isAround_ ? std::numbers::pi : std::asin(crown_.radiusM / distance_);
    }
    /// No part of it is higher than this, radians.
    [[nodiscard]] double highest() const {
        if (isAround_) return std::numbers::pi / 2;
        return std::atan2(crown_.topM - eye_.z, distance_ - crown_.radiusM);
    }

    struct Span {
        double low = 0, high = 0;  // radians
    };
    /// None: a ray at this azimuth misses it. Crowns are convex: what is between two hits is hit.
    [[nodiscard]] std::optional<Span> spanAt(double azimuth) const {
        constexpr int samples = 48;
        const double low = lowest(), step = (highest() - low) / samples;
        int first = -1, last = -1;
        for (int i = 0; i <= samples; ++i)
            if (isHit(azimuth, low + step * i)) {
                if (first < 0) first = i;
                last = i;
            }
        if (first < 0) return std::nullopt;
        return Span{first == 0 ? low : edge(azimuth, low + step * (first - 1), low + step * first),
                    last == samples ? highest() : edge(azimuth, low + step * (last + 1), low + step * last)};
    }
    [[nodiscard]] double chord(double azimuth, double altitude) const {
        return computeChord(crown_, eye_,
                            {std::cos(altitude) * std::sin(azimuth), std::cos(altitude) * std::cos(azimuth),
                             std::sin(altitude)});
    }

private:
    [[nodiscard]] double lowest() const {
        return std::max(0.0, std::atan2(crown_.bottomM - eye_.z, distance_ + crown_.radiusM));
    }
    [[nodiscard]] bool isHit(double azimuth, double altitude) const {
        return chord(azimuth, altitude) > 1e-6;
    }
    // Between an altitude that misses and one that hits.
    [[nodiscard]] double edge(double azimuth, double miss, double hit) const {
        for (int i = 0; i < 14; ++i) {
            const double middle = (miss + hit) / 2;
            (isHit(azimuth, middle) ? hit : miss) = middle;
        }
        return hit;
    }

    const Crown& crown_;
    glm::dvec3 eye_;
    double distance_;
    bool isAround_;
};

/// Sums up what a crown lets through over the sky that it covers.
class MeanTransmissivity {
public:
    void add(const CrownView& view, const Crown& crown, double azimuth, const CrownView::Span& span) {
        constexpr int samples = 8;
        for (int i = 0; i < samples; ++i) {
            const double altitude = span.low + (span.high - span.low) * (i + 0.5) / samples;
            const double sky = (span.high - span.low) * std::cos(altitude);
            const double chord = view.chord(azimuth, altitude);
            sky_ += sky;
            leafOn_ += sky * std::exp(-chord * crown.leafOnPerM);
            leafOff_ += sky * std::exp(-chord * crown.leafOffPerM);
        }
    }
    [[nodiscard]] double leafOn() const { return sky_ > 0 ? leafOn_ / sky_ : 1; }
    [[nodiscard]] double leafOff() const { return sky_ > 0 ? leafOff_ / sky_ : 1; }

private:
    double sky_ = 0, leafOn_ = 0, leafOff_ = 0;
};

// True azimuths at which a crown is looked at, degrees: from its left end to its right end, and at north,
// where drawings begin anew.
std::vector<double> listAzimuths(const CrownView& view, double northDeg) {
    constexpr double within = 0.9999;  // at its very ends a crown has no height
    const double half = view.isAround() ? 180 : degrees(view.halfWidth()) * within;
    double from = view.isAround() ? 0 : degrees(view.azimuth()) - northDeg - half;
    from -= 360 * std::floor(from / 360);
    const int parts = std::max(minColumns - 1, int(std::ceil(2 * half / columnDeg)));
    std::vector<double> azimuths;
    for (int i = 0; i <= parts; ++i) azimuths.push_back(from + 2 * half * i / parts);
    const auto north = std::ranges::upper_bound(azimuths, 360.0);
    if (north != azimuths.end() && north != azimuths.begin() && *std::prev(north) < 360)
        azimuths.insert(north, 360);
    return azimuths;
}

// None: it is hidden by the skyline, or too small to be seen.
std::optional<SeenCrown> seeCrown(const Crown& crown, std::uint32_t tree, glm::dvec3 eye,
                                  const Skyline& skyline, double northDeg) {
    const CrownView view(crown, eye);
    if (crown.topM <= eye.z || degrees(view.highest()) < smallestDeg) return std::nullopt;
    SeenCrown seen{.tree = tree, .columns = {}, .distanceM = view.distanceM()};
    MeanTransmissivity mean;
    bool isSeen = false;
    for (const double azimuthDeg : listAzimuths(view, northDeg)) {
        const double azimuth = Degrees{std::fmod(azimuthDeg + northDeg + 720, 360)}.radians().value;
        const auto span = view.spanAt(azimuth);
        if (!span) continue;
        seen.columns.push_back({azimuthDeg, degrees(span->low), degrees(span->high)});
        mean.add(view, crown, azimuth, *span);
        isSeen = isSeen || degrees(span->high) >=
                               degrees(std::atan(std::max(0.0, skyline.tanAt(azimuth)))) + smallestDeg;
    }
    if (!isSeen || seen.columns.size() < 2) return std::nullopt;
    seen.leafOnTransmissivity = mean.leafOn();
    seen.leafOffTransmissivity = mean.leafOff();
    return seen;
}

/// What crowns leave of the sun at each step.
struct LitShares {
    std::vector<float> evergreen, seasonal;
    [[nodiscard]] const std::vector<float>& of(TreeColumns column) const {
        return column == TreeColumns::evergreen ? evergreen : seasonal;
    }
};

LitShares weighCrowns(const CrownScene& scene, glm::dvec3 eye, const PointSteps& steps) {
    const SunPatches patches(steps.sun);
    CrownsOverPoint over(scene.crowns, patches, scene.phases);
    const bool any = over.begin(eye);
    LitShares lit;
    for (std::size_t i = 0; i < steps.sun.steps.size(); ++i) {
        const bool isShaded = steps.shaded[i] != 0;
        const auto depth = isShaded || !any ? CrownsOverPoint::Depth{0, 0} : over.at(i);
        lit.evergreen.push_back(isShaded ? 0 : float(1 - depth.takenShare(true)));
        lit.seasonal.push_back(isShaded ? 0 : float(1 - depth.takenShare(any && scene.inLeaf[i] != 0)));
    }
    return lit;
}

double sumMinutes(const std::vector<float>& shares, double stepMinutes) {
    return std::accumulate(shares.begin(), shares.end(), 0.0) * stepMinutes;
}

/// The times of a day at which neither buildings nor crowns darken a point.
class SunlitTimes {
public:
    SunlitTimes(const CrownScene& scene, glm::dvec3 eye, const Skyline& skyline, const PointSteps& day,
                const SunAt& sunAt)
        : crowns_(scene), skyline_(skyline), day_(day), sunAt_(sunAt), any_(crowns_.begin(eye, 0)) {}

    [[nodiscard]] std::vector<SunBand> find(TreeColumns column) const {
        ShadedSteps shaded = day_.shaded;
        for (std::size_t i = 0; any_ && i < shaded.size(); ++i)
            if (isDark(day_.sun.steps[i].direction, column)) shaded[i] = 1;
        auto bands = findSunBands(shaded, day_.sun, 0);
        refineSunBands(bands, day_.sun.stepMinutes, [&](Instant at) {
            const auto direction = sunAt_(at);
            return direction && !skyline_.hides(*direction) && !(any_ && isDark(*direction, column));
        });
        return bands;
    }

private:
    // Leaves are those of the day's first step.
    [[nodiscard]] bool isDark(glm::vec3 direction, TreeColumns column) const {
        return crowns_.at(0, glm::normalize(glm::dvec3(direction))).of(column) >=
               TreeShade::defaultShadedFrom;
    }

    CrownsOverPlace crowns_;
    const Skyline& skyline_;
    const PointSteps& day_;
    const SunAt& sunAt_;
    bool any_;
};

}  // namespace

std::optional<PointCrowns> lookAtCrowns(const City& city, const SkyPoint& point, const Skyline& skyline,
                                        const SkyFactors& sky, double northDeg, const PointSteps& year,
                                        const PointSteps& day, const SunAt& sunAt, const Zone& zone) {
    if (!city.trees || city.trees->trees.empty()) return std::nullopt;
    const City weighed = withTreesFor(city, TreeColumns::all);
    const auto eye = glm::dvec3(placeSurfaceRayOrigin(point.position, point.normal));
    PointCrowns all{.seen = {}, .leafDays = city.trees->leafDays, .trees = city.trees};
    const CivilDate date = day.sun.days.front().date;
    for (std::uint32_t i = 0; i < city.trees->trees.size(); ++i) {
        const Tree& tree = city.trees->trees[i];
        auto seen = seeCrown(makeCrown(tree), i, eye, skyline, northDeg);
        if (!seen) continue;
        seen->inLeaf = isInLeaf(leafDaysOf(tree, all.leafDays), date);
        all.seen.push_back(*std::move(seen));
    }
    std::ranges::stable_sort(all.seen, std::ranges::greater{}, &SeenCrown::distanceM);
    Box2 box;
    box.add(glm::vec2(point.position));
    const auto trees = findTreesInReach(weighed, box, point.position.z, year.sun);
    all.weighed = trees.size();
    if (all.seen.empty() && trees.empty()) return std::nullopt;
    const CrownScene inYear = makeCrownScene(city, trees, year.sun);
    const CrownScene onDay = makeCrownScene(city, trees, day.sun);
    const LitShares ofYear = weighCrowns(inYear, eye, year), ofDay = weighCrowns(onDay, eye, day);
    all.takenYear = takeFromPoint(inYear, glm::vec3(eye), year.sun, year.shaded);
    all.takenDay = takeFromPoint(onDay, glm::vec3(eye), day.sun, day.shaded);
    all.inLeaf = isInLeaf(all.leafDays, date);
    const SkyCrowns crowns(city);
    const SunlitTimes times(onDay, eye, skyline, day, sunAt);
    const auto shadeOf = [&](TreeColumns column) {
        const SkyFactors taken = crowns.taken(point, skyline, column);
        return PointShade{.minutes = sumSunlight(ofYear.of(column), year.sun, zone),
                          .dayMin = sumMinutes(ofDay.of(column), day.sun.stepMinutes),
                          .sunlit = times.find(column),
                          .sky = {std::max(0.0, sky.skyView - taken.skyView),
                                  std::max(0.0, sky.skyComponentPct - taken.skyComponentPct)}};
    };
    all.evergreen = shadeOf(TreeColumns::evergreen);
    all.seasonal = shadeOf(TreeColumns::seasonal);
    return all;
}

std::vector<TreeMinutes> listTakenByTree(const PointCrowns& crowns) {
    std::map<std::uint32_t, TreeMinutes> byTree;
    const auto add = [&](const std::vector<TreeTaken>& taken, double TreeMinutes::*minutes) {
        for (const TreeTaken& one : taken) byTree[one.tree].*minutes = one.attributedMinM2;
    };
    add(crowns.takenDay.evergreen, &TreeMinutes::dayEvergreen);
    add(crowns.takenDay.seasonal, &TreeMinutes::daySeasonal);
    add(crowns.takenYear.evergreen, &TreeMinutes::yearEvergreen);
    add(crowns.takenYear.seasonal, &TreeMinutes::yearSeasonal);
    std::vector<TreeMinutes> trees;
    for (auto& [tree, minutes] : byTree) {
        minutes.tree = tree;
        trees.push_back(minutes);
    }
    std::ranges::stable_sort(trees, std::ranges::greater{}, &TreeMinutes::yearSeasonal);
    return trees;
}

}  // namespace noonmark
