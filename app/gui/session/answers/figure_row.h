#pragma once

#include <vector>

#include "app/gui/session/answers/result_rows.h"
#include "core/describe/figure_text.h"

namespace noonmark {

/// A row for each figure in the user's language and units: label, value, and the definition as a tooltip.
std::vector<ResultRow> figureRows(const std::vector<FigureLine>& lines);

/// The same in one text: "Weighted shade +10 m² h, Shadow area 9 m²".
QString joinFigures(const std::vector<FigureLine>& lines);

/// The heading of a column of a figure: "Longest sun, h".
QString headingOf(const Figure& figure);

}  // namespace noonmark
