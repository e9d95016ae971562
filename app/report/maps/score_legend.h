#pragma once

#include "app/report/maps/legend_painter.h"
#include "scenarios/weights/score.h"

namespace noonmark {

/// A legend symmetric about 0: wanted shade has the colour of less shadow, unwanted shadow that of more. The
/// scale contains 98 % of the cells; `unit` states the largest value if it exceeds the scale.
Legend makeLegend(const Score& score, const LegendChoice& choice = {});

}  // namespace noonmark
