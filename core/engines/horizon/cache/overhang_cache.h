#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/engines/horizon/geometry/shadow_axes.h"
#include "core/engines/horizon/overhangs/overhang_shapes.h"

namespace noonmark {

/// The overhangs of a city that changes by a few buildings at a time.
class OverhangCache {
public:
    [[nodiscard]] bool empty() const { return shapes_.empty(); }

    /// Number of overhang shapes of buildings that may shade the grid's cells from suns of this tangent or
    /// higher, at any azimuth. `but`: owners to exclude, ascending.
    [[nodiscard]] std::size_t reaching(const Grid& grid, double lowestTan,
                                       std::span<const std::uint64_t> but = {}) const;
    void add(OverhangShapes shapes, std::uint64_t owner);
    std::vector<OverhangShapes> remove(std::span<const std::uint64_t> owners);

    /// Overhangs of buildings that may shade cells within an extent from suns of this tangent or higher.
    /// Replaces the contents of `list`. `alongPerMetre`: cells along per metre of distance.
    void across(const ShadowAxes& axes, const ShadowExtent& extent, double lowestTan, double alongPerMetre,
                OverhangList& list) const;

private:
    std::vector<OverhangShapes> shapes_;
    std::vector<std::uint64_t> owners_;  // one per entry; ascending
};

}  // namespace noonmark
