#pragma once

#include "core/measures/has_runs.h"
#include "scenarios/impact/impact_figures.h"

namespace noonmark {

/// Whether the longest runs of both fields were counted, as of core/measures/has_runs.h. In files their
/// change is null or empty where they were not.
inline bool hasRuns(const Impact& impact) { return hasRuns(impact.continuousMin); }
inline bool hasRuns(const ImpactFigures& figures) { return !std::isnan(figures.continuous.meanMin); }

}  // namespace noonmark
