#pragma once

#include <optional>

#include "app/report/maps/legend_painter.h"
#include "scenarios/weights/score.h"

namespace noonmark {

/// A legend symmetric about 0: wanted shade has the colour of less shadow, unwanted shadow that of more. The
/// scale contains 98 % of the cells; `unit` states the largest value if it exceeds the scale.
Legend makeLegend(const Score& score);

/// The colour of a cell; empty where there is no receiver. `top`: that of the legend's scale.
std::optional<QColor> pickColour(const Score& score, std::size_t cell, double top);

}  // namespace noonmark
