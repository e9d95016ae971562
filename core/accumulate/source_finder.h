#pragma once

#include <array>
#include <cstdint>
#include <stop_token>
#include <vector>

#include "core/accumulate/ray_scene.h"
#include "core/accumulate/shadow_lines.h"

namespace noonmark {

/// Finds what throws a shadow on the cells of a flat grid (z = 0) at one instant, with rays in packets of 16
/// neighbours.
class SourceFinder {
public:
    /// `wanted`: grid order, cells to look from.
    SourceFinder(RayScene scene, const Grid& grid, const std::vector<bool>& wanted, int levels,
                 float nearestHitM);

    /// `towardsSun`: unit vector. Reuses the arrays of `sources`. All cores; incomplete after a stop request.
    void find(glm::dvec3 towardsSun, ShadowSources& sources, const std::stop_token& stop) const;

    [[nodiscard]] std::uint64_t raysAnInstant() const { return rays_; }

private:
    /// Up to 16 wanted cells close together.
    struct Packet {
        std::array<std::uint32_t, 16> cells{};
        int count = 0;
    };
    void find(const Packet& packet, glm::dvec3 towardsSun, ShadowSources& sources,
              std::vector<Occluder>& occluders) const;

    RayScene scene_;
    Grid grid_;
    int levels_;
    float nearestHitM_;
    std::uint64_t rays_ = 0;
    std::vector<Packet> packets_;
};

}  // namespace noonmark
