#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <span>
#include <vector>

#include "core/engines/projected/casters/shadow_casters.h"
#include "core/engines/projected/filling/step_filler.h"
#include "core/sun/sun_steps.h"

namespace noonmark {

/// What decides how far casters' shadows reach, one entry a caster.
struct CasterExtents {
    std::vector<double> lowX, lowY, highX, highY;  ///< bounds of the points, cells
    std::vector<double> topM;

    void add(const ShadowCaster& caster) {
        lowX.push_back(caster.low.x);
        lowY.push_back(caster.low.y);
        highX.push_back(caster.high.x);
        highY.push_back(caster.high.y);
        topM.push_back(double(caster.topM));
    }
};

/// A test of the extents of casters against a rectangle of cells. All ranges include 0 or a margin, so that
/// only the top of a caster matters.
struct ReachLimits {
    /// A coordinate of a caster, plus an offset for each metre of its top, must touch a range.
    struct Axis {
        double minimum = 0, maximum = 0;  ///< offset per metre
        double low = 0, high = 0;         ///< the range
    };
    Axis x, y, across;
    glm::dvec2 acrossUnit{1, 0};  ///< across the mean direction in which shadows fall
};

/// Bit i: caster first + i may touch the rectangle. At most 64 casters. Backend: caster_extents_hwy.cpp.
std::uint64_t findTouching(const CasterExtents& extents, std::size_t first, std::size_t count,
                           const ReachLimits& limits);

/// Tests whether shadows at some consecutive steps can touch a rectangle of cells: by the bounds of the swept
/// shadow, and by its extent across the mean direction in which shadows fall, which rules out most casters
/// while the sun is low and not in line with the grid.
class CasterReach {
public:
    /// Steps [first, end) of the sun, of one day.
    CasterReach(const SunSteps& sun, double cellM, std::size_t first, std::size_t end);

    /// Sets the rectangle, in cells; both ends are centres of cells.
    void aimAt(glm::dvec2 low, glm::dvec2 high);

    /// Bit i: the shadow of caster first + i may cover a centre in the rectangle at one of the steps. Never 0
    /// where it does. At most 64 casters.
    [[nodiscard]] std::uint64_t touching(const CasterExtents& extents, std::size_t first,
                                         std::size_t count) const {
        return findTouching(extents, first, count, limits_);
    }

    [[nodiscard]] const StepOffsets& offsets() const { return offsets_; }

private:
    StepOffsets offsets_;
    ReachLimits limits_;
};

/// Casters by neighbourhood: those whose middle lies in the same square of some 100 m form a group. A group
/// is tested for reach as one caster that encloses all of them.
class CasterGroups {
public:
    CasterGroups() = default;
    /// `casters` must outlive this object.
    CasterGroups(const ShadowCasters& casters, double cellM);

    [[nodiscard]] std::size_t count() const { return ends_.size(); }
    /// Places in indices() and extents() of the group's casters: [firstOf, endOf).
    [[nodiscard]] std::size_t firstOf(std::size_t group) const { return group == 0 ? 0 : ends_[group - 1]; }
    [[nodiscard]] std::size_t endOf(std::size_t group) const { return ends_[group]; }
    /// Indices of all casters, by group.
    [[nodiscard]] std::span<const std::uint32_t> indices() const { return order_; }
    [[nodiscard]] const CasterExtents& extents() const { return extents_; }
    [[nodiscard]] const ShadowCasters& casters() const { return *casters_; }

    [[nodiscard]] bool mayTouch(std::size_t group, const CasterReach& reach) const {
        return reach.touching(enclosing_, group, 1) != 0;
    }

    /// All groups, those nearest to a rectangle of cells first: they cover it most.
    [[nodiscard]] std::vector<std::uint32_t> nearestFirst(glm::dvec2 low, glm::dvec2 high) const;

private:
    const ShadowCasters* casters_ = nullptr;
    CasterExtents enclosing_;  // of each group: a prism from the ground to its highest point
    CasterExtents extents_;
    std::vector<std::uint32_t> order_;
    std::vector<std::size_t> ends_;
};

}  // namespace noonmark
