#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/engines/horizon/geometry/azimuth_bins.h"

namespace noonmark {

/// A step of the period, in time order.
struct TimedStep {
    StepPlace place;
    bool startsRun = false;  ///< it is the first of a day, or steps are missing before it
};

std::vector<TimedStep> makeTimedSteps(const SunSteps& sun, const BinnedSun& binned);

/// The steps [first, end) of a day, or of a part of it without gaps.
struct DaySteps {
    std::uint32_t first = 0, end = 0;
};

/// The days of these steps, in time order.
std::vector<DaySteps> findDays(std::span<const TimedStep> steps);

/// Number of receivers that are counted together.
inline constexpr std::size_t lanesPerPart = 64;

/// Horizon codes of one bin, or counts of steps, one per receiver.
struct alignas(64) RunLanes {
    std::int16_t values[lanesPerPart] = {};
};

/// Walks the steps of a day: raises `longest` to the longest run of each lane, in steps. `horizons`: one
/// entry per bin. 1 ns a step with AVX-512.
void walkSteps(std::span<const RunLanes> horizons, std::span<const TimedStep> steps, RunLanes& longest);

/// A step whose horizons are those of a span of altitudes in a bin.
struct SpanStep {
    std::uint32_t span = 0;
    HorizonCode sun = 0;
    bool startsRun = false;
};

/// What 64 receivers have hidden in a span: the suns of codes lower than `below`, and those higher than
/// `above`. Aligned as RunLanes are.
struct SpanLanes {
    const HorizonCode* below = nullptr;
    const HorizonCode* above = nullptr;
};

/// The same by spans. Some 2 ns a step.
void walkSpans(std::span<const SpanLanes> spans, std::span<const SpanStep> steps, RunLanes& longest);

}  // namespace noonmark
