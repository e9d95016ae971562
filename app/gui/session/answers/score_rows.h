#pragma once

#include "app/gui/session/answers/result_rows.h"
#include "scenarios/weights/score.h"

namespace noonmark {

/// The table of a score: the total, each month and each interval with sunlit time.
std::vector<ResultRow> makeScoreRows(const Score& score, const std::string& scenario,
                                     const std::string& weights, const std::string& period);

/// "Jan 2026"
QString describeMonth(std::chrono::year_month month);

}  // namespace noonmark
