#pragma once

#include <span>
#include <vector>

#include "core/describe/answer_page.h"
#include "core/engines/api/shadow_field.h"

namespace noonmark {

/// How much of the whole gets how many hours of sun a day, in % of it. `sunMin`: minutes of sun a day of
/// parts of equal size; NaN: no part of it. `possibleMin`: the most that is possible. Classes of a quarter,
/// half, one or two hours, at most 14, each with its lower limit; the last one with its upper limit, too. No
/// groups: no part, or no sun.
Bars makeSunHistogram(std::span<const double> sunMin, double possibleMin, std::string_view title);
/// Of the area of a field's receivers.
Bars makeSunHistogram(const ShadowField& field);

/// How much area changes by how many minutes, m2. `minutes`: of each cell of `cellAreaM2`; NaN: no receiver.
/// Cells that change by no more than `noChangeMin` are left out. Classes of equal width, at most 14. Where
/// sun is shown, minutes of sun that are gained or lost.
Bars makeChangeHistogram(std::span<const float> minutes, double cellAreaM2, double noChangeMin,
                         ShownAs show = ShownAs::shadow);

}  // namespace noonmark
