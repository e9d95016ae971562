#pragma once

#include <cstddef>

#include "scenarios/weights/time_weights.h"

namespace noonmark {

/// A table with one more interval, and where it stands.
struct AddedInterval {
    TimeWeights table;
    std::size_t position = 0;
};

/// Adds an interval of weight 0, all day: over the first days after the interval `after` that no interval
/// holds, up to the next one or the end of the year; where every day is held, over the later half of the days
/// of `after`, with its hours and weight. Error: that one holds a single day. A table has an interval at
/// least.
Result<AddedInterval> addInterval(TimeWeights table, std::size_t after);

/// Without the interval at `position`. Error: it is the only one.
Result<TimeWeights> removeInterval(TimeWeights table, std::size_t position);

}  // namespace noonmark
