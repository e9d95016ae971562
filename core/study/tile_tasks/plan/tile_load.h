#pragma once

#include "core/engines/auto_engine.h"
#include "core/study/study.h"
#include "core/study/tile_tasks/plan/tile_halo.h"

namespace noonmark {

/// Estimated cost of a tile.
struct TileCost {
    double seconds = 0;      ///< on two cores like those of docs/scale.md, reading and writing included
    double memoryBytes = 0;  ///< peak of a process that runs only this tile
    double readBytes = 0;    ///< of it, for the buildings within the halo
};

/// `terrainPosts`: 0 without terrain. Within a factor of two as a rule: scheduling needs no more.
TileCost estimateTile(const TileHalo& halo, const Grid& tile, const StudySettings& settings,
                      const SunSteps& sun, std::size_t terrainPosts, const EngineList& engines);

}  // namespace noonmark
