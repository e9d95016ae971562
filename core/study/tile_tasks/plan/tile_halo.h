#pragma once

#include "core/engines/common/shadow_reach.h"
#include "core/receivers/tile_plan.h"
#include "core/study/tile_tasks/plan/occluder_survey.h"

namespace noonmark {

/// What surrounds a tile as far as it matters to it.
struct TileHalo {
    Box2 occluders;  ///< the tile, and every coarse cell whose highest point can shade it at some step
    /// `occluders` and all of each building that touches it, so that a reader of this box finds its buildings
    /// complete, with all their parts
    Box2 reads;
    /// Sums over the coarse cells of `reads`
    std::size_t buildings = 0;
    std::size_t points = 0;
    std::size_t overhangTriangles = 0;
    std::size_t buildingsInTile = 0;
};

/// The halo of a tile of receivers. Each cell is taken for a box as high as its highest building, so that the
/// result is never too small (ShadowReach::touches). O(cells x azimuth degrees visited).
TileHalo findHalo(const OccluderSurvey& survey, const ShadowReach& reach, const Grid& tile);

}  // namespace noonmark
