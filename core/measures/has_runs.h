#pragma once

#include <algorithm>
#include <cmath>
#include <span>

#include "core/engines/api/shadow_field.h"
#include "core/measures/sampled_error.h"
#include "core/measures/statistics.h"

namespace noonmark {

// Whether the longest runs were counted (core/engines/api/shadow_counts.h). Where they were not, minutes of
// continuous shadow are NaN in every cell and every figure: there is nothing to show or to write of them.

/// Of a map of runs, or of their change. Reads as far as the first number: all cells where there is none.
inline bool hasRuns(std::span<const float> continuousMin) {
    return std::ranges::any_of(continuousMin, [](float minutes) { return !std::isnan(minutes); });
}
inline bool hasRuns(const ShadowField& field) { return hasRuns(field.continuousMin); }

inline bool hasRuns(const ShadowStatistics& figures) { return !std::isnan(figures.meanContinuousMin); }
inline bool hasRuns(const SampledError& error) { return !std::isnan(error.continuous.meanMin); }

}  // namespace noonmark
