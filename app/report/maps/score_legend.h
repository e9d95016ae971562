#pragma once

#include <optional>

#include "app/report/maps/legend_painter.h"
#include "scenarios/weights/score.h"

namespace noonmark {

/// Symmetric about 0: shade that is wanted in the colour of less shadow, shadow that is unwanted in that of
/// more. The ends are where 98 % of the cells lie within; `unit` names the largest where that is more.
Legend makeLegend(const Score& score);

/// The colour of a cell; none where there is no receiver. `top`: the legend's.
std::optional<QColor> pickColour(const Score& score, std::size_t cell, double top);

}  // namespace noonmark
