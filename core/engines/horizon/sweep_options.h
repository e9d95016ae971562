#pragma once

#include <vector>

#include "core/engines/api/engine_registry.h"
#include "core/engines/horizon/horizon_sweep.h"

namespace noonmark {

/// Options of engines that sweep horizons: "error", "bin", "runs" and "check".
std::vector<EngineOption> sweepOptions();

/// Missing options take their defaults; options of other engines are ignored.
HorizonSweepSettings readSweepSettings(const EngineSettings& settings);

}  // namespace noonmark
