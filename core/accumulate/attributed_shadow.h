#pragma once

#include <stop_token>
#include <vector>

#include "core/accumulate/direction_graph.h"
#include "core/accumulate/interval_engine.h"
#include "core/progress.h"

namespace noonmark {

/// Which building throws the shadow, minutes x m2 of the whole period.
struct AttributedShadow {
    /// By index in City::buildings: of the shaded cell-minutes, those for which it is the first thing on the
    /// way to the sun.
    std::vector<double> minM2;
    double totalMinM2 = 0;  ///< their sum: gross shadow of all receivers
};

/// From the same intervals, at the same error, as GraphAccumulator with this engine and these settings.
/// Error: what the engine refuses; an engine that does not know its sources; cancelled().
Result<AttributedShadow> attributedShadow(const IntervalEngine& engine,
                                          const DirectionGraphSettings& settings, const City& city,
                                          const Receivers& receivers, const SunSteps& sun, Progress& progress,
                                          std::stop_token stop);

}  // namespace noonmark
