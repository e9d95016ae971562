#pragma once

#include <vector>

#include "core/accumulate/accrual/accrual_settings.h"
#include "core/accumulate/direction_graph.h"
#include "core/accumulate/engine_list.h"

namespace noonmark {

/// What a user may set on every engine that shades one interval at a time: "interval" and "bound".
std::vector<EngineOption> graphOptions();
DirectionGraphSettings graphSettings(const EngineSettings& settings);

/// The same, before them "map" and "bias", for engines that do it with depth maps of at most `largestMap`
/// texels a side.
std::vector<EngineOption> accrualOptions(int largestMap);
AccrualSettings accrualSettings(const EngineSettings& settings);

/// Memory of accrual maps of a grid: places of receivers, bits and masks of an interval, and some 30 maps of
/// runs alive in a year. Bytes a cell.
inline constexpr double accrualBytesPerCell = 160;

}  // namespace noonmark
