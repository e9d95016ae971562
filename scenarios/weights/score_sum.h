#pragma once

#include <vector>

#include "scenarios/weights/score.h"
#include "scenarios/weights/time_pieces.h"

namespace noonmark {

/// Adds the shadow of pieces up to a score.
class ScoreSum {
public:
    ScoreSum(const Receivers& receivers, const TimeWeights& weights, const std::vector<TimePiece>& pieces);

    /// `minutes`: in shadow in the piece's steps, times `factor`; grid order.
    void add(const TimePiece& piece, const std::vector<float>& minutes, double factor = 1);

    /// Without engine and warnings.
    [[nodiscard]] Score finish() &&;

private:
    const Receivers& receivers_;
    const TimeWeights& weights_;
    std::vector<double> sunlit_;  // minutes of every interval, in the table's order
    std::vector<double> sum_;     // of cells
    Score score_;                 // until finish() the months' shadow areas are cell-minutes x m2
};

}  // namespace noonmark
