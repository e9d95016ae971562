#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/engines/horizon/geometry/shadow_axes.h"
#include "core/engines/horizon/overhangs/overhang_shapes.h"

namespace noonmark {

/// What hangs in a city that changes by a few buildings at a time.
class OverhangCache {
public:
    [[nodiscard]] bool empty() const { return shapes_.empty(); }

    /// How many of buildings that may shade the grid's cells from suns of this tangent and higher, wherever
    /// these stand. `but`: not of these owners, ascending.
    [[nodiscard]] std::size_t reaching(const Grid& grid, double lowestTan,
                                       std::span<const std::uint64_t> but = {}) const;
    void add(OverhangShapes shapes, std::uint64_t owner);
    std::vector<OverhangShapes> remove(std::span<const std::uint64_t> owners);

    /// Those of buildings that may shade cells in an extent from suns of this tangent and higher. Replaces
    /// what is in `list`. `alongPerMetre`: cells along a metre of distance.
    void across(const ShadowAxes& axes, const ShadowExtent& extent, double lowestTan, double alongPerMetre,
                OverhangList& list) const;

private:
    std::vector<OverhangShapes> shapes_;
    std::vector<std::uint64_t> owners_;  // of each; ascending
};

}  // namespace noonmark
