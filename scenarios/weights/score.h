#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "core/engines/api/step_sets.h"
#include "core/study/study.h"
#include "core/sun/sun_steps.h"
#include "scenarios/weights/time_weights.h"

namespace noonmark {

/// One month of the period.
struct MonthFigures {
    std::chrono::year_month month;
    double shadowAreaM2 = 0;  ///< sum of (share of the month's sunlit time in shadow x cell area)
    double scoreM2 = 0;       ///< the month's part of the score; the months add up to it
    double sunlitMinutes = 0;
    double weightedShadeM2h = 0;  ///< the month's part; the months add up to the total
};

struct IntervalFigures {
    std::string name;
    double weight = 0;
    double shadowAreaM2 = 0;  ///< as in MonthFigures, over the interval's sunlit time
    double scoreM2 = 0;       ///< weight x shadow area
    double weightedShadeM2h = 0;
};

/// The sums of a score over its region.
struct ScoreTotals {
    double scoreM2 = 0;
    double receiverAreaM2 = 0;
    double waterM2 = 0;           ///< of the region's cells on water, which are no receivers
    double weightedShadeM2h = 0;  ///< NaN: of a result saved before it was counted
};

/// A score with trees: a step counts the share of the sun that buildings and crowns take.
struct ShadedScore : ScoreTotals {
    TreeColumns column = TreeColumns::seasonal;  ///< or evergreen
    std::vector<float> score;                    ///< as that without trees
    std::vector<MonthFigures> months;            ///< likewise, of the same months
    std::vector<IntervalFigures> intervals;      ///< likewise
};

/// The same for tables, which hold no map.
inline std::vector<ShadedScore> withoutMaps(std::vector<ShadedScore> scores) {
    for (ShadedScore& score : scores) score.score.clear();
    return scores;
}

/// Shadow score (paper, section 5.4). At a receiver: the sum over intervals of weight x share of the
/// interval's sunlit time in shadow. Over a region: the sum over receivers of that x cell area. Positive
/// where wanted shade outweighs unwanted shadow. An interval that is cut in two counts twice, as each share
/// is of its own interval.
///
/// Weighted shade: the sum over the steps of weight x hours in shadow x cell area, m2 h over the period. How
/// the table is cut into intervals does not change it.
struct Score : ScoreTotals {
    Grid grid;
    std::vector<float> score;                ///< one per cell, NaN where there is no receiver; grid order
    std::vector<MonthFigures> months;        ///< of the period, in order
    std::vector<IntervalFigures> intervals;  ///< of the weight table, in its order
    std::string engine;                      ///< name and settings, as text
    std::string engineKey;                   ///< key of the engine that computed it
    /// Errors of a cell, of the total and of the weighted shade, on a sample against the ray reference. None:
    /// not measured, or the reference computed it.
    std::vector<ShownError> errors;
    /// Evergreens first. Empty: no tree reaches a receiver, or none is wanted.
    std::vector<ShadedScore> withTrees;
    std::string treesHow;  ///< how they were measured, as text
    Warnings warnings;
};

/// Null: without trees, or the score has no map of that column.
const ShadedScore* findColumn(const Score& score, TreeColumns column);
/// The column that is shown where `wanted` is chosen: without trees where the score has no map of it.
TreeColumns columnOf(const Score& score, TreeColumns wanted);
/// The map of that column. Valid as long as the score.
const std::vector<float>& scoreInColumn(const Score& score, TreeColumns column);
/// The score as shown in one column, in place of that without trees, and no columns besides; itself where it
/// has no map of that column. Its errors are those without trees and left out.
std::shared_ptr<const Score> showColumn(const std::shared_ptr<const Score>& score, TreeColumns column);

/// Computes the score over given steps. `zone`: time zone of their wall clock. The horizon sweep and
/// projected shadows process the city once for all months and intervals, at the cost of one field. Any other
/// engine runs once per combination of month and interval. The engine "auto" chooses once, and `engine`
/// states its choice. `trees`: the columns that are also measured. Error: an invalid table, or an error of
/// the engine.
Result<Score> computeScore(const City& city, const Receivers& receivers, const SunSteps& sun,
                           const Zone& zone, const TimeWeights& weights, const Engine& engine,
                           Progress& progress, const std::stop_token& stop,
                           TreeColumns trees = TreeColumns::without);

/// Places receivers in `settings.region`, computes the steps of the sun, the score, its errors and, as
/// `settings.trees` asks, the score with trees. Errors as of runStudy() and computeScore().
Result<Score> runScore(const City& city, const StudySettings& settings, const TimeWeights& weights,
                       Progress& progress, const std::stop_token& stop,
                       const EngineList& engines = coreEngines());

/// The steps of a period that lie in one month and one interval of a weight table.
struct TimePiece {
    std::chrono::year_month month;
    std::optional<std::size_t> interval;  ///< index in the table; empty: steps outside every interval
    SunSteps sun;                         ///< contains only the days that have steps in this piece
    std::vector<std::uint32_t> steps;     ///< indices of the piece's steps in the period
};

/// Splits the period: each step is in exactly one piece; pieces are sorted by their first step. O(steps x
/// intervals).
std::vector<TimePiece> splitIntoPieces(const SunSteps& sun, const Zone& zone, const TimeWeights& weights);

/// One set of the period's steps per piece. At most 65,535 pieces.
StepSets makeSets(const std::vector<TimePiece>& pieces, const SunSteps& sun);

/// Accumulates the shadow of time pieces into a score.
class ScoreSum {
public:
    ScoreSum(const Receivers& receivers, const TimeWeights& weights, const std::vector<TimePiece>& pieces);

    /// `minutes` x `factor`: minutes in shadow during the steps of the piece; grid order.
    void add(const TimePiece& piece, const std::vector<float>& minutes, double factor = 1);

    /// The score without `engine`, trees and `warnings`.
    [[nodiscard]] Score finish() &&;

private:
    const Receivers& receivers_;
    const TimeWeights& weights_;
    std::vector<double> sunlit_;  // minutes per interval, in the table's order
    std::vector<double> sum_;     // one per cell
    Score score_;                 // until finish() the months' shadow areas are in cell-minutes x m2
};

}  // namespace noonmark
