#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/engines/projected/casters/shadow_casters.h"

namespace noonmark {

/// Casters by neighbourhood: those whose middle lies in the same square of some 100 m form a group. A group
/// is tested for reach as one caster that encloses all of them.
class CasterGroups {
public:
    CasterGroups() = default;
    /// `casters` must outlive this object.
    CasterGroups(const ShadowCasters& casters, double cellM);

    [[nodiscard]] std::size_t count() const { return enclosing_.size(); }
    /// A prism from the ground to the group's highest point, with its bounds only.
    [[nodiscard]] const ShadowCaster& enclosing(std::size_t group) const { return enclosing_[group]; }
    /// Indices of the group's casters, the largest first.
    [[nodiscard]] std::span<const std::uint32_t> of(std::size_t group) const {
        const std::size_t first = group == 0 ? 0 : ends_[group - 1];
        return std::span(order_).subspan(first, ends_[group] - first);
    }
    [[nodiscard]] const ShadowCasters& casters() const { return *casters_; }

    /// All groups, those nearest to a rectangle of cells first: they cover it most.
    [[nodiscard]] std::vector<std::uint32_t> nearestFirst(glm::dvec2 low, glm::dvec2 high) const;

private:
    const ShadowCasters* casters_ = nullptr;
    std::vector<ShadowCaster> enclosing_;
    std::vector<std::uint32_t> order_;
    std::vector<std::size_t> ends_;
};

}  // namespace noonmark
