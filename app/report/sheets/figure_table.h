#pragma once

#include <vector>

#include "app/report/maps/style.h"
#include "app/report/sheets/study_words.h"

namespace noonmark {

/// Paints a table of names and values from the top of `area`, a hairline below each row, the first row in
/// bold. Values are right-aligned; a name that does not fit beside its value is cut with an ellipsis. Returns
/// the y below the table.
double paintFigures(const Canvas& canvas, const QRectF& area, const std::vector<FigureText>& figures,
                    double points);

}  // namespace noonmark
