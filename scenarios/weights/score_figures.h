#pragma once

#include "core/describe/figure.h"
#include "scenarios/weights/score.h"

namespace noonmark {

const Figures<ScoreTotals>& scoreFigures();
const Figures<MonthFigures>& scoreMonthFigures();        ///< of a month, without its name
const Figures<IntervalFigures>& scoreIntervalFigures();  ///< of an interval, without its name

}  // namespace noonmark
