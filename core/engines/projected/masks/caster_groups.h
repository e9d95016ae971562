#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/engines/projected/casters/shadow_casters.h"
#include "core/engines/projected/masks/caster_reach.h"

namespace noonmark {

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
