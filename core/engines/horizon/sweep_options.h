#pragma once

#include <vector>

#include "core/engines/api/engine_registry.h"
#include "core/engines/horizon/horizon_sweep.h"

namespace noonmark {

/// What a user may set on engines that sweep horizons: "error", "bin", "runs" and "check".
std::vector<EngineOption> sweepOptions();

/// What is left out is as usual; options of other engines are passed over.
HorizonSweepSettings readSweepSettings(const EngineSettings& settings);

}  // namespace noonmark
