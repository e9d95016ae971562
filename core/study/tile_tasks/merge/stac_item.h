#pragma once

#include <string>

#include "core/measures/statistics.h"
#include "core/study/study.h"
#include "core/study/tile_tasks/plan/task_plan.h"
#include "core/study/tiles/tile_maps.h"

namespace noonmark {

/// A STAC item (SpatioTemporal Asset Catalog 1.0.0, with the projection extension) for the maps of a
/// district: its outline in degrees, the first and last instant of the period, and its files as assets, with
/// paths relative to the item.
std::string makeStacItem(const TaskPlan& plan, const District& district, const std::vector<TileMap>& maps,
                         const SunSteps& sun, const Period& period, const ShadowStatistics& statistics);

}  // namespace noonmark
