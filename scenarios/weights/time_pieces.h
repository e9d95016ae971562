#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/engines/api/step_sets.h"
#include "core/sun/sun_steps.h"
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

}  // namespace noonmark
