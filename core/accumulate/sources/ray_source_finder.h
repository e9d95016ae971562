#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/accumulate/ray_scene.h"
#include "core/accumulate/sources/source_finder.h"

namespace noonmark {

/// With rays in packets of 16 neighbours (paper, section 5).
class RaySourceFinder final : public SourceFinder {
public:
    RaySourceFinder(RayScene scene, const Grid& grid, int levels, float nearestHitM);
    void find(glm::dvec3 towardsSun, ShadowSources& sources, const std::stop_token& stop) const override;
    [[nodiscard]] std::uint64_t raysAnInstant() const override { return grid_.size(); }

private:
    /// Up to 16 cells close together.
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
    std::vector<Packet> packets_;
};

}  // namespace noonmark
