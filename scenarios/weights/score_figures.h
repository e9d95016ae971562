#pragma once

#include "core/describe/answer_page.h"
#include "core/describe/figure.h"
#include "scenarios/weights/score.h"

namespace noonmark {

const Figures<ScoreTotals>& scoreFigures();
const Figures<MonthFigures>& scoreMonthFigures();        ///< of a month, without its name
const Figures<IntervalFigures>& scoreIntervalFigures();  ///< of an interval, without its name

/// What a score says: whether wanted shade outweighs unwanted shadow, and both by month.
AnswerPage makePage(const Score& score, const std::string& scenario, ShownAs show = ShownAs::shadow);

}  // namespace noonmark
