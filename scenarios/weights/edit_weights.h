#pragma once

#include <cstddef>

#include "scenarios/weights/time_weights.h"

namespace noonmark {

/// A table with one more interval, and the index of that interval.
struct AddedInterval {
    TimeWeights table;
    std::size_t position = 0;
};

/// Adds an interval of weight 0, all day, on the first free days after the interval `after`, up to the next
/// interval or the end of the year. If no day is free, the new interval takes the later half of the days of
/// `after` with its hours and weight. Error: `after` covers a single day. The table must not be empty.
Result<AddedInterval> addInterval(TimeWeights table, std::size_t after);

/// Removes the interval at `position`. Error: it is the only one.
Result<TimeWeights> removeInterval(TimeWeights table, std::size_t position);

}  // namespace noonmark
