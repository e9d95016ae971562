#pragma once

#include "core/measures/has_runs.h"
#include "scenarios/impact/impact_figures.h"

namespace noonmark {

/// Whether continuous shadow was computed for both fields, as in core/measures/has_runs.h. Where it was not,
/// files hold its change as null or an empty field.
inline bool hasRuns(const Impact& impact) { return hasRuns(impact.continuousMin); }
inline bool hasRuns(const ImpactFigures& figures) { return !std::isnan(figures.continuous.meanMin); }

}  // namespace noonmark
