#pragma once

#include <vector>

#include "core/engines/accrual/accrual_settings.h"
#include "core/engines/api/engine_registry.h"
#include "core/engines/graph/direction_graph.h"

namespace noonmark {

/// Options of every engine that shades one interval at a time: "interval" and "bound".
std::vector<EngineOption> graphOptions();
DirectionGraphSettings readGraphSettings(const EngineSettings& settings);

/// The same, preceded by "map" and "bias", for engines that use depth maps of at most `largestMap` texels per
/// side.
std::vector<EngineOption> accrualOptions(int largestMap);
AccrualSettings readAccrualSettings(const EngineSettings& settings);

/// Memory of accrual maps of a grid, bytes per cell: positions of receivers, bits and masks of an interval,
/// and some 30 maps of runs alive during a year.
inline constexpr double accrualBytesPerCell = 160;

}  // namespace noonmark
