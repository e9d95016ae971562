#pragma once

#include <vector>

#include "core/accumulate/engine_list.h"
#include "core/accumulate/horizon_sweep.h"

namespace noonmark {

/// What a user may set on engines that sweep horizons: "error", "bin", "runs" and "check".
std::vector<EngineOption> sweepOptions();

/// What is left out is as usual; options of other engines are passed over.
HorizonSweepSettings sweepSettings(const EngineSettings& settings);

}  // namespace noonmark
