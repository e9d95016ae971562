#pragma once

#include <vector>

#include "app/gui/session/answers/result_rows.h"
#include "scenarios/impact/impact_text.h"

namespace noonmark {

/// The table of a comparison: areas with more and with less shadow for each threshold, means, largest
/// changes, cells that stopped or started being receivers, and the contribution of each new building.
std::vector<ResultRow> makeComparisonRows(const ComparisonFigures& figures);

/// "1,234 m² more" and "56 m² less" on a line each, or "no change".
QString describeChangedArea(const ChangeFigures& figures);

}  // namespace noonmark
