#pragma once

#include <cstdint>
#include <glm/vec2.hpp>

#include "core/engines/projected/filling/caster_fill.h"
#include "core/engines/projected/masks/caster_extents.h"
#include "core/sun/sun_steps.h"

namespace noonmark {

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

    [[nodiscard]] const StepOffsets& offsets() const { return throws_; }

private:
    StepOffsets throws_;
    ReachLimits limits_;
};

}  // namespace noonmark
