#pragma once

#include <chrono>
#include <stop_token>
#include <string>
#include <vector>

#include "core/study/study.h"
#include "scenarios/weights/time_weights.h"

namespace noonmark {

/// A month of the period.
struct MonthFigures {
    std::chrono::year_month month;
    double shadowAreaM2 =
        0;               ///< sum over receivers of (share of the month's sunlit time in shadow x cell area)
    double scoreM2 = 0;  ///< what the month adds to the score; months add up to it
    double sunlitMinutes = 0;
};

struct IntervalFigures {
    std::string name;
    double weight = 0;
    double shadowAreaM2 = 0;  ///< share of the interval's sunlit time
    double scoreM2 = 0;       ///< weight x shadow area
};

/// Shadow score (paper, section 5.4): at a receiver the sum over intervals of weight x share of the
/// interval's sunlit time in shadow; over a region that times the cell area. Positive where shade is wanted
/// more than shadow is unwanted.
struct Score {
    Grid grid;
    std::vector<float> score;  ///< one a cell, NaN where there is no receiver; grid order
    double scoreM2 = 0;
    double receiverAreaM2 = 0;
    std::vector<MonthFigures> months;        ///< of the period, in order
    std::vector<IntervalFigures> intervals;  ///< of the table, in its order
    std::string engine;                      ///< name and settings in words
    std::string engineKey;                   ///< of the engine that made it
    Warnings warnings;
};

/// The score over steps that are made already. `zone`: of the steps' wall clock. The horizon sweep and
/// projected shadows look at the city once for all months and intervals, at the cost of one field. Any other
/// engine runs once for every part of the period that lies in one month and one interval. The engine auto is
/// asked once, and what it chose is said in `engine`. Error: a table that is not sound, or the engine's.
Result<Score> computeScore(const City& city, const Receivers& receivers, const SunSteps& sun,
                           const Zone& zone, const TimeWeights& weights, const Engine& engine,
                           Progress& progress, const std::stop_token& stop);

/// Receivers, sun and score over `settings.region`. Errors as of runStudy and scoreOf.
Result<Score> runScore(const City& city, const StudySettings& settings, const TimeWeights& weights,
                       Progress& progress, const std::stop_token& stop,
                       const EngineList& engines = coreEngines());

}  // namespace noonmark
