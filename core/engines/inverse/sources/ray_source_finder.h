#pragma once

#include "core/engines/inverse/sources/source_finder.h"
#include "core/engines/ray/ray_scene.h"

namespace noonmark {

/// Finds sources with rays, in packets of 16 neighbours (paper, section 5).
class RaySourceFinder final : public SourceFinder {
public:
    RaySourceFinder(RayScene scene, const Grid& grid, int levels, float nearestHitM);
    [[nodiscard]] int levels() const override { return levels_; }
    [[nodiscard]] std::unique_ptr<SourceInstant> at(glm::dvec3 towardsSun, const Lanes& lanes) const override;
    [[nodiscard]] std::uint64_t raysAnInstant() const override { return cells_; }

private:
    RayScene scene_;
    std::uint64_t cells_;
    int levels_;
    float nearestHitM_;
};

}  // namespace noonmark
