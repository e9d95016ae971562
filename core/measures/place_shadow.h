#pragma once

#include <span>

#include "core/engines/api/step_masks.h"
#include "core/sun/sun_steps.h"

namespace noonmark {

/// Shadow on the cells of one place over one day, in the baseline and in the scenario. The cells are those
/// that are receivers in both; cells that a building of either covers are left out. Bit c of both masks is
/// the same cell. Days with no step above the horizon have no steps.
///
/// Each step counts `stepMinutes` and has the sun of its beginning. A gap between the slots of two steps
/// (SunStep::slot) ends an unbroken run.
struct PlaceShadow {
    CivilDate day;
    std::span<const SunStep> steps;  ///< of the day; belongs to the period's SunSteps
    double cellAreaM2 = 1;
    double stepMinutes = 1;
    StepMasks baseline;  ///< masks over the place's own cells only
    StepMasks scenario;  ///< as large; equal to `baseline` where no scenario is given

    [[nodiscard]] double areaM2() const { return double(baseline.receivers) * cellAreaM2; }
};

}  // namespace noonmark
