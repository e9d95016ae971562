#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/engines/api/step_sets.h"
#include "core/sun/sun_steps.h"
#include "scenarios/weights/score.h"
#include "scenarios/weights/time_weights.h"

namespace noonmark {

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

    /// The score without `engine` and `warnings`.
    [[nodiscard]] Score finish() &&;

private:
    const Receivers& receivers_;
    const TimeWeights& weights_;
    std::vector<double> sunlit_;  // minutes per interval, in the table's order
    std::vector<double> sum_;     // one per cell
    Score score_;                 // until finish() the months' shadow areas are in cell-minutes x m2
};

}  // namespace noonmark
