#pragma once

#include "core/study/tile_tasks/plan/task_plan.h"
#include "scenarios/weights/time_weights.h"

namespace noonmark {

/// Two cities of one project to be compared tile by tile.
struct ComparedCities {
    std::shared_ptr<const City> before, after;
    Region region;
};

/// The impact of a scenario as the subject of a plan. Its cells equal those of runImpact() with the same
/// engine to the last bit, if the engine's cells do not depend on their surroundings; the engine "auto"
/// chooses for each tile, once for both cities. No error is measured. Figures of a tile: those of
/// ImpactFigures that are sums, without and with the default threshold; with trees as in
/// "touched_m2_seasonal", with maps of their own ("impact_seasonal").
TileSubject makeImpactSubject(const ComparedCities& cities);

/// Its maps: `after` and `before` (gross and continuous shadow on the receivers that both cities have), and
/// `impact`, after minus before.
std::vector<TileMap> listImpactMaps(const LegendChoice& legend = {});

/// A city to be scored tile by tile.
struct ScoredCity {
    std::shared_ptr<const City> city;
    Region region;
    TimeWeights weights;
};

/// The score of a scenario as the subject of a plan. Its cells equal those of runScore() with the same engine
/// to the last bit, if the engine's cells do not depend on their surroundings; the engine "auto" chooses for
/// each tile. Figures of a tile: weighted_shade_m2h, score_m2 and receiver_area_m2; and by month of the
/// period, as in "score_m2_2026-03", weighted_shade_m2h, score_m2 and shadow_area_m2. With trees likewise, as
/// in "score_m2_2026-03_seasonal", with maps of their own.
TileSubject makeScoreSubject(const ScoredCity& scored);

/// Its map: `score`.
std::vector<TileMap> listScoreMaps(const LegendChoice& legend = {});

}  // namespace noonmark
