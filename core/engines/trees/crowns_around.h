#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <numbers>
#include <numeric>
#include <span>
#include <unordered_map>
#include <vector>

#include "core/city/trees/tree.h"
#include "core/engines/trees/crowns.h"
#include "core/sun/sun_steps.h"

namespace noonmark {

/// Optical depths with all crowns in leaf, and out of season or in a phase.
struct CrownDepth {
    double inLeaf = 0, bare = 0;
    /// Share of the sun that is taken. `isInLeaf`: CrownScene::inLeaf.
    [[nodiscard]] double takenShare(bool isInLeaf) const { return -std::expm1(-(isInLeaf ? inLeaf : bare)); }
};

/// The crowns that may stand between one receiver and the sun, by azimuth. Reuses its memory.
class CrownsAround {
public:
    static constexpr int slots = 360;

    /// The slot of a direction's azimuth.
    static std::uint16_t slotOf(glm::dvec3 direction) {
        return std::uint16_t(slotOf(std::atan2(direction.x, direction.y)));
    }

    /// `some`: indices of `crowns`; `lowestTan`: of the lowest sun's altitude. False if there are none. Some
    /// ns a crown.
    bool gather(const std::vector<Crown>& crowns, std::span<const std::uint32_t> some, glm::dvec3 origin,
                double lowestTan) {
        for (auto& slot : crowns_) slot.clear();
        any_ = false;
        for (const std::uint32_t index : some) add(crowns[index], index, origin, lowestTan);
        return any_;
    }

    [[nodiscard]] std::span<const std::uint32_t> at(std::uint16_t slot) const { return crowns_[slot]; }

    /// Of a ray from the receiver. `crowns`, `origin`: as gathered; `slot`: of the direction, a unit vector.
    [[nodiscard]] CrownDepth depthAt(std::uint16_t slot, const std::vector<Crown>& crowns, glm::dvec3 origin,
                                     glm::dvec3 direction, const LeafPhases& phases,
                                     std::size_t phase) const {
        CrownDepth depth;
        for (const std::uint32_t index : crowns_[slot]) {
            const Crown& crown = crowns[index];
            const double chord = computeChord(crown, origin, direction);
            depth.inLeaf += chord * crown.leafOnPerM;
            depth.bare += chord * phases.perM(phase, crown);
        }
        return depth;
    }

private:
    static int slotOf(double azimuth) {
        const double turn = azimuth / (2 * std::numbers::pi);
        return int((turn - std::floor(turn)) * slots) % slots;
    }

    void add(const Crown& crown, std::uint32_t index, glm::dvec3 origin, double lowestTan) {
        const double x = crown.x - origin.x, y = crown.y - origin.y, distance = std::hypot(x, y);
        const double reach = crown.radiusM * (1 + 1e-6) + 1e-3;
        if (crown.topM <= origin.z) return;
        if (distance > reach && (crown.topM - origin.z) < lowestTan * (1 - 1e-6) * (distance - reach)) return;
        const double slotWidth = 2 * std::numbers::pi / slots;
        const double half = distance <= reach ? std::numbers::pi : std::asin(reach / distance);
        const int count = std::min(slots, int(2 * half / slotWidth) + 2);
        const int first = slotOf(std::atan2(x, y) - half);
        for (int i = 0; i < count; ++i) crowns_[std::size_t((first + i) % slots)].push_back(index);
        any_ = true;
    }

    std::array<std::vector<std::uint32_t>, slots> crowns_;
    bool any_ = false;
};

/// The sun's steps by degrees of azimuth and altitude, as a rule by half degrees, the sun's own width: to
/// crowns, the suns of a patch are one.
class SunPatches {
public:
    static constexpr double sunDeg = 0.5;

    explicit SunPatches(const SunSteps& sun) : SunPatches(std::span(sun.steps)) {}
    /// `apart`: the kind of each step; suns of two kinds are never in one patch; empty: there is one kind.
    explicit SunPatches(std::span<const SunStep> steps, double sideDeg = sunDeg,
                        std::span<const std::uint16_t> apart = {}) {
        std::unordered_map<std::int64_t, std::uint32_t> known;
        std::vector<glm::dvec3> sums;
        for (std::size_t i = 0; i < steps.size(); ++i) {
            const glm::dvec3 direction = glm::normalize(glm::dvec3(steps[i].direction));
            lowestTan_ = std::min(lowestTan_, direction.z / std::hypot(direction.x, direction.y));
            const std::int64_t key = keyOf(direction, sideDeg) * 65536 + (apart.empty() ? 0 : apart[i]);
            const auto [found, isNew] = known.try_emplace(key, std::uint32_t(sums.size()));
            if (isNew) sums.emplace_back(0);
            sums[found->second] += direction;
            ofStep_.push_back(found->second);
        }
        for (const glm::dvec3& sum : sums) {
            directions_.push_back(glm::normalize(sum));
            slots_.push_back(CrownsAround::slotOf(directions_.back()));
        }
    }

    [[nodiscard]] std::size_t count() const { return directions_.size(); }
    /// Of a step.
    [[nodiscard]] std::uint32_t ofStep(std::size_t step) const { return ofStep_[step]; }
    [[nodiscard]] glm::dvec3 direction(std::uint32_t patch) const { return directions_[patch]; }
    [[nodiscard]] std::uint16_t slot(std::uint32_t patch) const { return slots_[patch]; }
    [[nodiscard]] double lowestTan() const { return lowestTan_; }

private:
    static std::int64_t keyOf(glm::dvec3 direction, double sideDeg) {
        const double perRadian = 180 / std::numbers::pi / sideDeg;
        const double azimuth = std::atan2(direction.x, direction.y);
        const double altitude = std::asin(std::clamp(direction.z, -1.0, 1.0));
        return std::int64_t(std::floor(azimuth * perRadian)) * 1000 +
               std::int64_t(std::floor(altitude * perRadian));
    }

    std::vector<std::uint32_t> ofStep_;
    std::vector<glm::dvec3> directions_;  // the mean of each patch
    std::vector<std::uint16_t> slots_;    // of azimuth
    double lowestTan_ = 1e9;
};

/// What a scene's crowns take of the sun from one place after the other, in exact directions. Reuses its
/// memory; for one thread. The scene must outlive it.
class CrownsOverPlace {
public:
    explicit CrownsOverPlace(const CrownScene& scene) : scene_(scene), all_(scene.crowns.size()) {
        std::iota(all_.begin(), all_.end(), 0U);
    }
    /// False: none can shade it.
    bool begin(glm::dvec3 origin, double lowestTan) {
        origin_ = origin;
        return around_.gather(scene_.crowns, all_, origin, lowestTan);
    }

    struct Taken {
        double evergreen = 0, seasonal = 0;  ///< shares of the sun
        [[nodiscard]] double of(TreeColumns column) const {
            return column == TreeColumns::evergreen ? evergreen : seasonal;
        }
    };
    /// `step`: of the scene's steps, whose leaves count. `direction`: of the sun, a unit vector.
    [[nodiscard]] Taken at(std::size_t step, glm::dvec3 direction) const {
        const CrownDepth depth = around_.depthAt(CrownsAround::slotOf(direction), scene_.crowns, origin_,
                                                 direction, scene_.phases, scene_.phases.at(step));
        return {depth.takenShare(true), depth.takenShare(scene_.inLeaf[step] != 0)};
    }

private:
    const CrownScene& scene_;
    std::vector<std::uint32_t> all_;
    CrownsAround around_;
    glm::dvec3 origin_{};
};

/// What crowns let through to one point, found where it is asked for. Reuses its memory; for one thread.
/// Crowns, patches and phases must outlive it.
class CrownsOverPoint {
public:
    CrownsOverPoint(const std::vector<Crown>& crowns, const SunPatches& patches, const LeafPhases& phases)
        : crowns_(crowns),
          patches_(patches),
          phases_(phases),
          all_(crowns.size()),
          depths_(patches.count() * phases.count()) {
        std::iota(all_.begin(), all_.end(), 0U);
    }

    /// False: none can shade it. `some`: indices of the crowns that come into question.
    bool begin(glm::dvec3 origin) { return begin(origin, all_); }
    bool begin(glm::dvec3 origin, std::span<const std::uint32_t> some) {
        origin_ = origin;
        std::ranges::fill(depths_, Depth{notFound, 0});
        return around_.gather(crowns_, some, origin, patches_.lowestTan());
    }

    using Depth = CrownDepth;
    /// Of a step of the patches.
    const Depth& at(std::size_t step) {
        const std::uint32_t patch = patches_.ofStep(step);
        const std::size_t phase = phases_.at(step);
        Depth& depth = depths_[patch * phases_.count() + phase];
        if (depth.inLeaf == notFound)
            depth = around_.depthAt(patches_.slot(patch), crowns_, origin_, patches_.direction(patch),
                                    phases_, phase);
        return depth;
    }

private:
    static constexpr double notFound = -1;
    const std::vector<Crown>& crowns_;
    const SunPatches& patches_;
    const LeafPhases& phases_;
    std::vector<std::uint32_t> all_;
    std::vector<Depth> depths_;
    CrownsAround around_;
    glm::dvec3 origin_{};
};

}  // namespace noonmark
