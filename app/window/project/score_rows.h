#pragma once

#include "app/window/study/result_rows.h"
#include "scenarios/weights/score.h"

namespace noonmark {

/// A score line by line: of all, of every month and of every interval that has sunlit time.
std::vector<ResultRow> makeScoreRows(const Score& score, const std::string& scenario,
                                     const std::string& weights, const std::string& period);

/// "Jan 2026"
QString describeMonth(std::chrono::year_month month);

}  // namespace noonmark
