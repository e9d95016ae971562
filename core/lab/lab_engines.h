#pragma once

#include "core/engines/api/engine_registry.h"

namespace noonmark {

// The folder core/lab holds the paper's engines, kept for comparison, and the experiments that time them. It
// is a library of its own, which programs link where a study is asked for as in the paper; core does without.

/// The paper's engines: accrual maps and rays through the direction graph.
const EngineList& labEngines();

/// Core's engines and those of the lab, in display order: the automatic choice is last.
const EngineList& coreAndLabEngines();

}  // namespace noonmark
