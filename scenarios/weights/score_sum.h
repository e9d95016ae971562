#pragma once

#include <vector>

#include "scenarios/weights/score.h"
#include "scenarios/weights/time_pieces.h"

namespace noonmark {

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
