#pragma once

#include <vector>

#include "app/window/study/result_rows.h"
#include "scenarios/impact/impact_text.h"

namespace noonmark {

/// What one scenario changes against another, line by line: areas of more and of less shadow for each
/// threshold, means, the largest change, cells that are no receivers, and each new building by itself.
std::vector<ResultRow> makeComparisonRows(const ComparisonFigures& figures);

/// "1,234 m² more" and "56 m² less", a line each; "nowhere".
QString describeChangedArea(const ChangeFigures& figures);

}  // namespace noonmark
