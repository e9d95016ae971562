#include "core/engines/points/sky_factors.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <numeric>
#include <span>
#include <utility>

#include "core/engines/ray/surface_rays.h"
#include "core/engines/trees/crowns.h"
#include "core/engines/trees/crowns_around.h"

namespace noonmark {

namespace {

// The azimuth's part of the integrals up to an altitude, for a surface whose normal has the component `up`
// and, at this azimuth, `towards`: the antiderivatives of (up sin + towards cos) cos, plain and times (1 + 2
// sin) / 3.
struct SkyIntegral {
    double even = 0;
    double overcast = 0;

    static SkyIntegral upToTan(double tan, double up, double towards) {
        if (std::isinf(tan)) return upTo(std::numbers::pi / 2, 1, 0, up, towards);
        const double cosine = 1 / std::sqrt(1 + tan * tan);
        return upTo(std::atan(tan), tan * cosine, cosine, up, towards);
    }
    static SkyIntegral upTo(double altitude, double sine, double cosine, double up, double towards) {
        const double level = altitude / 2 + sine * cosine / 2;
        return {up * sine * sine / 2 + towards * level,
                (up * (sine * sine / 2 + 2 * sine * sine * sine / 3) +
                 towards * (level - 2 * cosine * cosine * cosine / 3)) /
                    3};
    }
    void add(const SkyIntegral& more, double weight) {
        even += weight * more.even;
        overcast += weight * more.overcast;
    }
};

// The altitudes that the surface faces are visible; what is behind its plane is hidden like everything else.
std::vector<HiddenAltitudes> hiddenFrom(const Skyline& skyline, double azimuth, double up, double towards) {
    std::vector<HiddenAltitudes> hidden = skyline.hiddenAt(azimuth);
    constexpr double infinite = std::numeric_limits<double>::infinity();
    constexpr double upright = 1e-7;
    if (std::abs(up) < upright) {
        if (towards <= 0) hidden.push_back({0, infinite});
    } else if (up > 0) {
        if (towards < 0) hidden.push_back({0, -towards / up});
    } else {
        hidden.push_back({std::max(0.0, towards / -up), infinite});
    }
    joinOverlaps(hidden);
    return hidden;
}

SkyIntegral integrateAltitudes(const Skyline& skyline, double azimuth) {
    const glm::dvec3 normal(skyline.normal());
    const double towards = normal.x * std::sin(azimuth) + normal.y * std::cos(azimuth);
    SkyIntegral visible;
    visible.add(SkyIntegral::upTo(std::numbers::pi / 2, 1, 0, normal.z, towards), 1);
    visible.add(SkyIntegral::upTo(0, 0, 1, normal.z, towards), -1);
    for (const HiddenAltitudes& hidden : hiddenFrom(skyline, azimuth, normal.z, towards)) {
        visible.add(SkyIntegral::upToTan(hidden.highTan, normal.z, towards), -1);
        visible.add(SkyIntegral::upToTan(hidden.lowTan, normal.z, towards), 1);
    }
    return visible;
}

// The same at an azimuth at which only the skyline hides sky, from a wall that faces it.
SkyIntegral integrateAboveSkyline(const SeenEdge* piece, double towards, double sine, double cosine) {
    const double tan = piece != nullptr ? std::max(0.0, piece->east * sine + piece->north * cosine) : 0;
    SkyIntegral visible = SkyIntegral::upTo(std::numbers::pi / 2, 1, 0, 0, towards);
    visible.add(SkyIntegral::upToTan(tan, 0, towards), -1);
    return visible;
}

/// Gauss's rule on -1 to 1.
struct GaussRule {
    std::span<const double> places, weights;
};

// Five points where altitudes change much between two azimuths; the narrower, the fewer. An altitude that
// changes by d radians gives an error below d^2n / (2n)!: 1e-9 of the sky in all.
GaussRule chooseRule(double change) {
    static constexpr std::array p1{0.0}, w1{2.0};
    static constexpr std::array p2{-0.5773502691896258, 0.5773502691896258}, w2{1.0, 1.0};
    static constexpr std::array p3{-0.7745966692414834, 0.0, 0.7745966692414834},
        w3{0.5555555555555556, 0.8888888888888888, 0.5555555555555556};
    static constexpr std::array p5{0.0, 0.5384693101056831, -0.5384693101056831, 0.9061798459386640,
                                   -0.9061798459386640},
        w5{0.5688888888888889, 0.4786286704993665, 0.4786286704993665, 0.2369268850561891,
           0.2369268850561891};
    if (change < 1e-4) return {p1, w1};
    if (change < 0.02) return {p2, w2};
    if (change < 0.15) return {p3, w3};
    return {p5, w5};
}

/// Integrates the visible sky of one skyline over azimuths without breaks between them.
class SkyIntegrator {
public:
    explicit SkyIntegrator(const Skyline& skyline)
        : skyline_(skyline), normal_(skyline.normal()), isWall_(std::abs(normal_.z) < 1e-7) {}

    [[nodiscard]] SkyIntegral between(double from, double to) const {
        const double middle = (from + to) / 2, half = (to - from) / 2;
        if (isWall_ && towards(std::sin(middle), std::cos(middle)) <= 0) return {};
        const bool hasFaces = !skyline_.facesNear(from).empty() || !skyline_.facesNear(middle).empty() ||
                              !skyline_.facesNear(to).empty();
        const SeenEdge* const piece = skyline_.pieceAt(middle);
        const double steepness = piece != nullptr ? std::hypot(piece->east, piece->north) : 0;
        const bool isPlain = isWall_ && !hasFaces;
        constexpr double steepOverhang = 20;  // their edges may be near
        const double change = (to - from) * std::max(hasFaces ? steepOverhang : 1.0, steepness);
        const GaussRule rule = chooseRule(isWall_ ? change : 1.0);
        SkyIntegral sum;
        for (std::size_t i = 0; i < rule.places.size(); ++i) {
            const double azimuth = middle + rule.places[i] * half;
            sum.add(isPlain ? above(piece, azimuth) : integrateAltitudes(skyline_, azimuth),
                    rule.weights[i] * half);
        }
        return sum;
    }

private:
    [[nodiscard]] double towards(double sine, double cosine) const {
        return normal_.x * sine + normal_.y * cosine;
    }
    [[nodiscard]] SkyIntegral above(const SeenEdge* piece, double azimuth) const {
        const double sine = std::sin(azimuth), cosine = std::cos(azimuth);
        return integrateAboveSkyline(piece, towards(sine, cosine), sine, cosine);
    }

    const Skyline& skyline_;
    glm::dvec3 normal_;
    bool isWall_;
};

}  // namespace

SkyFactors computeSkyFactors(const Skyline& skyline) {
    constexpr double widest = std::numbers::pi / 180;
    const std::vector<double> breaks = skyline.breaks();
    const SkyIntegrator integrator(skyline);
    SkyIntegral sum;
    for (std::size_t i = 0; i + 1 < breaks.size(); ++i) {
        const double width = breaks[i + 1] - breaks[i];
        const int parts = std::max(1, int(std::ceil(width / widest)));
        for (int part = 0; part < parts; ++part)
            sum.add(
                integrator.between(breaks[i] + width * part / parts, breaks[i] + width * (part + 1) / parts),
                1);
    }
    const double openOvercast =
        7 * std::numbers::pi / 9;  // of a level surface, in units of the zenith's brightness
    return {sum.even / std::numbers::pi, 100 * sum.overcast / openOvercast};
}

namespace {

constexpr int skyAzimuths = 2 * CrownsAround::slots, skyAltitudes = 180;  // of half a degree each
constexpr double columnWidth = 2 * std::numbers::pi / skyAzimuths,
                 altitudeStep = std::numbers::pi / 2 / skyAltitudes;
constexpr double lowestCrownTan = 0.004;  // of crowns that are looked at: half of the lowest direction

/// Optical depths of the crowns of one season: with leaves and without.
struct SkyDepth {
    double inLeaf = 0, bare = 0;
};

/// The directions of one azimuth. Reuses its memory.
class SkyColumn {
public:
    void begin(double azimuth) {
        sine = std::sin(azimuth);
        cosine = std::cos(azimuth);
        for (const std::uint32_t season : seasons_) depths_[season].fill({});
        seasons_.clear();
        first = skyAltitudes;
        end = 0;
    }

    void add(const Crown& crown, glm::dvec3 origin) {
        const double distance = std::hypot(crown.x - origin.x, crown.y - origin.y);
        const double near = std::max(0.0, distance - crown.radiusM), far = distance + crown.radiusM;
        const auto altitudeOf = [&](double upM, double awayM) {
            return int(std::atan2(upM, awayM) / altitudeStep);
        };
        const double top = crown.topM - origin.z, bottom = crown.bottomM - origin.z;
        const int from = std::clamp(altitudeOf(bottom, bottom > 0 ? far : near), 0, skyAltitudes - 1);
        const int to = std::clamp(altitudeOf(top, near), 0, skyAltitudes - 1);
        auto& depths = depthsOf(crown.season);
        for (int i = from; i <= to; ++i) addChord(crown, origin, i, depths[std::size_t(i)]);
        first = std::min(first, from);
        end = std::max(end, to + 1);
    }

    /// Share of a direction's light that crowns take in the mean of the phases.
    [[nodiscard]] double takenShare(int i, std::span<const LeafTime> phases) const {
        double taken = 0;
        for (const LeafTime& phase : phases) {
            double sum = 0;
            for (const std::uint32_t season : seasons_) {
                const SkyDepth& depth = depths_[season][std::size_t(i)];
                sum += phase.inLeaf[season] != 0 ? depth.inLeaf : depth.bare;
            }
            taken -= phase.share * std::expm1(-sum);
        }
        return taken;
    }

    double sine = 0, cosine = 1;        ///< of the azimuth
    int first = skyAltitudes, end = 0;  ///< directions that crowns are in

private:
    std::array<SkyDepth, skyAltitudes>& depthsOf(std::uint32_t season) {
        if (std::ranges::find(seasons_, season) == seasons_.end()) seasons_.push_back(season);
        if (season >= depths_.size()) depths_.resize(season + 1);
        return depths_[season];
    }
    void addChord(const Crown& crown, glm::dvec3 origin, int i, SkyDepth& depth) const {
        const double altitude = (i + 0.5) * altitudeStep, level = std::cos(altitude);
        const double chord = computeChord(crown, origin, {level * sine, level * cosine, std::sin(altitude)});
        depth.inLeaf += chord * crown.leafOnPerM;
        depth.bare += chord * crown.leafOffPerM;
    }

    std::vector<std::uint32_t> seasons_;                      // of the crowns at this azimuth
    std::vector<std::array<SkyDepth, skyAltitudes>> depths_;  // by season
};

// The share of a direction's altitudes that nothing hides.
double visibleShare(const std::vector<HiddenAltitudes>& hidden, int i) {
    const double low = i * altitudeStep, top = low + altitudeStep;
    double visible = 1;
    for (const HiddenAltitudes& part : hidden) {
        const double from = std::max(low, std::atan(double(part.lowTan)));
        const double to = std::min(top, std::atan(double(part.highTan)));
        if (to > from) visible -= (to - from) / altitudeStep;
    }
    return std::max(0.0, visible);
}

// What a surface receives from the half degrees around a direction: under a sky of equal brightness, and
// under an overcast sky (CIE) in units of the zenith's brightness.
SkyIntegral computeLight(const SkyColumn& column, glm::dvec3 normal, int i) {
    const double altitude = (i + 0.5) * altitudeStep, sine = std::sin(altitude), cosine = std::cos(altitude);
    const double towards = normal.x * column.sine + normal.y * column.cosine;
    const double facing = normal.z * sine + towards * cosine;
    if (facing <= 0) return {};
    return {facing * cosine * columnWidth * altitudeStep,
            (1 + 2 * sine) / 3 * facing * cosine * columnWidth * altitudeStep};
}

}  // namespace

SkyCrowns::SkyCrowns(const City& city) {
    if (!city.trees) return;
    LeafSeasons seasons(city.trees->leafDays);
    for (const Tree& tree : city.trees->trees) {
        crowns_.push_back(makeCrown(tree));
        crowns_.back().season = seasons.add(tree);
    }
    constexpr int days = 365;
    std::map<std::vector<bool>, int> known;
    for (int day = 1; day <= days; ++day) {
        std::vector<bool> inLeaf;
        for (const LeafDays& season : seasons.days()) inLeaf.push_back(season.inLeafOn(day));
        ++known[std::move(inLeaf)];
    }
    for (const auto& [inLeaf, count] : known)
        year_.push_back({{inLeaf.begin(), inLeaf.end()}, double(count) / days});
    alwaysInLeaf_.push_back({std::vector<std::uint8_t>(seasons.days().size(), 1), 1});
}

SkyFactors SkyCrowns::taken(const SkyPoint& point, const Skyline& skyline, TreeColumns column) const {
    const glm::dvec3 origin(placeSurfaceRayOrigin(point.position, point.normal));
    std::vector<std::uint32_t> all(crowns_.size());
    std::iota(all.begin(), all.end(), 0U);
    CrownsAround around;
    if (!around.gather(crowns_, all, origin, lowestCrownTan)) return {};
    const std::vector<LeafTime>& phases = column == TreeColumns::evergreen ? alwaysInLeaf_ : year_;
    SkyColumn directions;
    SkyIntegral sum;
    for (int i = 0; i < skyAzimuths; ++i) {
        const double azimuth = (i + 0.5) * columnWidth;
        directions.begin(azimuth);
        const auto crowns = around.at(CrownsAround::slotOf({directions.sine, directions.cosine, 0}));
        if (crowns.empty()) continue;
        for (const std::uint32_t crown : crowns) directions.add(crowns_[crown], origin);
        const auto hidden = skyline.hiddenAt(azimuth);
        for (int k = directions.first; k < directions.end; ++k)
            sum.add(computeLight(directions, glm::dvec3(point.normal), k),
                    visibleShare(hidden, k) * directions.takenShare(k, phases));
    }
    const double openOvercast = 7 * std::numbers::pi / 9;  // of a level surface
    return {sum.even / std::numbers::pi, 100 * sum.overcast / openOvercast};
}

}  // namespace noonmark
