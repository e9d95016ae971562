#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <span>
#include <vector>

#include "core/accumulate/horizon/open_triangles.h"
#include "core/accumulate/horizon/shadow_axes.h"

namespace noonmark {

/// The triangles of what hangs in a city that changes by a few buildings at a time.
class KeptOpen {
public:
    [[nodiscard]] std::span<const OpenTriangle> all() const { return triangles_; }
    [[nodiscard]] bool empty() const { return triangles_.empty(); }

    /// Those of buildings that may shade the grid's cells from suns of this tangent and higher, wherever
    /// these stand. `but`: not of these owners, ascending.
    [[nodiscard]] std::size_t reaching(const Grid& grid, double lowestTan,
                                       std::span<const std::uint64_t> but = {}) const;
    void add(std::span<const OpenTriangle> triangles, std::uint64_t owner);
    std::vector<OpenTriangle> remove(std::span<const std::uint64_t> owners);

    /// Those of buildings that may shade cells in an extent from suns of this tangent and higher. Replaces
    /// what is in `triangles`. `alongPerMetre`: cells along a metre of distance.
    void across(const ShadowAxes& axes, const ShadowExtent& extent, double lowestTan, double alongPerMetre,
                std::vector<OpenTriangle>& triangles) const;

private:
    struct Group {
        std::uint64_t owner;
        std::uint32_t first, end;
        glm::dvec2 low, high;  // bounds, cells
        double topM;
    };
    [[nodiscard]] std::span<const OpenTriangle> of(const Group& group) const {
        return std::span(triangles_).subspan(group.first, group.end - group.first);
    }

    [[nodiscard]] bool has(std::span<const std::uint64_t> owners) const;

    std::vector<OpenTriangle> triangles_;
    std::vector<Group> groups_;  // in the order of the triangles
};

}  // namespace noonmark
