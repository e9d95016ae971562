#include "core/accumulate/horizon/kept_open.h"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace noonmark {

std::size_t KeptOpen::reaching(const Grid& grid, double lowestTan, std::span<const std::uint64_t> but) const {
    const glm::dvec2 last(grid.columns, grid.rows);
    std::size_t size = 0;
    for (const Group& group : groups_) {
        const glm::dvec2 apart = glm::max(glm::max(group.low - last, -group.high), glm::dvec2(0));
        const double reach = group.topM / (grid.cellM * lowestTan) + 2;
        if (glm::length(apart) <= reach && !std::ranges::binary_search(but, group.owner))
            size += group.end - group.first;
    }
    return size;
}

bool KeptOpen::has(std::span<const std::uint64_t> owners) const {
    return std::ranges::any_of(
        groups_, [&](const Group& group) { return std::ranges::binary_search(owners, group.owner); });
}

void KeptOpen::add(std::span<const OpenTriangle> triangles, std::uint64_t owner) {
    if (triangles.empty()) return;
    const auto first = std::uint32_t(triangles_.size());
    Group group{owner, first, std::uint32_t(first + triangles.size()), glm::dvec2(1e30), glm::dvec2(-1e30),
                -1e30};
    for (const OpenTriangle& triangle : triangles)
        for (const glm::dvec3 corner : triangle) {
            group.low = glm::min(group.low, glm::dvec2(corner));
            group.high = glm::max(group.high, glm::dvec2(corner));
            group.topM = std::max(group.topM, corner.z);
        }
    triangles_.insert(triangles_.end(), triangles.begin(), triangles.end());
    groups_.push_back(group);
}

std::vector<OpenTriangle> KeptOpen::remove(std::span<const std::uint64_t> owners) {
    std::vector<OpenTriangle> removed, kept;
    if (!has(owners)) return removed;
    std::vector<Group> groups;
    for (Group group : groups_) {
        const auto triangles = of(group);
        const bool gone = std::ranges::binary_search(owners, group.owner);
        group.first = std::uint32_t(kept.size());
        std::vector<OpenTriangle>& to = gone ? removed : kept;
        to.insert(to.end(), triangles.begin(), triangles.end());
        group.end = std::uint32_t(kept.size());
        if (!gone) groups.push_back(group);
    }
    triangles_ = std::move(kept);
    groups_ = std::move(groups);
    return removed;
}

void KeptOpen::across(const ShadowAxes& axes, const ShadowExtent& extent, double lowestTan,
                      double alongPerMetre, std::vector<OpenTriangle>& triangles) const {
    triangles.clear();
    for (const Group& group : groups_) {
        ShadowExtent own;
        own.addBox(axes, group.low, group.high);
        const double reach = group.topM * alongPerMetre / lowestTan + 2;
        if (own.highQ < extent.lowQ || own.lowQ > extent.highQ || own.lowAlong > extent.highAlong ||
            own.highAlong + reach < extent.lowAlong)
            continue;
        triangles.insert(triangles.end(), of(group).begin(), of(group).end());
    }
}

}  // namespace noonmark
