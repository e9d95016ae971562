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

/// The steps of a period that lie in one month and in one interval of a table.
struct TimePiece {
    std::chrono::year_month month;
    std::optional<std::size_t> interval;  ///< index; nothing: none holds them
    SunSteps sun;                         ///< its days are those that have steps here
    std::vector<std::uint32_t> steps;     ///< which of the period's they are
};

/// All steps, each in just one piece, in the order in which the pieces begin. O(steps x intervals).
std::vector<TimePiece> splitIntoPieces(const SunSteps& sun, const Zone& zone, const TimeWeights& weights);

/// Each piece as one set of the period's steps. At most 65,535 pieces.
StepSets makeSets(const std::vector<TimePiece>& pieces, const SunSteps& sun);

}  // namespace noonmark
