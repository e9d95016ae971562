#pragma once

#include "core/describe/figure.h"
#include "core/measures/place_sums.h"

namespace noonmark {

/// The areas of a place at one step, without its time.
const Figures<PlaceStep>& placeStepFigures();

const Figures<AreaHours>& areaHoursFigures();

}  // namespace noonmark
