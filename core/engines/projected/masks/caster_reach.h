#pragma once

#include <glm/vec2.hpp>

#include "core/engines/projected/filling/caster_fill.h"
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

    /// Never false for a caster whose shadow covers a centre in the rectangle at one of the steps.
    [[nodiscard]] bool touches(const ShadowCaster& caster) const;

    [[nodiscard]] const StepOffsets& offsets() const { return throws_; }

private:
    StepOffsets throws_;
    glm::dvec2 across_{1, 0};                  // unit vector
    double leastAcross_ = 0, mostAcross_ = 0;  // of the offsets, per metre of height; 0 lies between them
    glm::dvec2 low_{}, high_{};
    double lowAcross_ = 0, highAcross_ = 0;
};

}  // namespace noonmark
