#pragma once

#include "core/study/tile_tasks/plan/tile_subject.h"

namespace noonmark {

/// Two cities of one project to be compared tile by tile.
struct ComparedCities {
    std::shared_ptr<const City> before, after;
    Region region;
};

/// The impact of a scenario as the subject of a plan. Its cells equal those of runImpact() with the same
/// engine to the last bit, if the engine's cells do not depend on their surroundings; the engine "auto"
/// chooses for each tile, once for both cities. No error is measured. Figures of a tile: those of
/// ImpactFigures that are sums, without and with the default threshold.
TileSubject makeImpactSubject(const ComparedCities& cities);

/// Its maps: `after` and `before` (gross and continuous shadow on the receivers that both cities have), and
/// `impact`, after minus before.
std::vector<TileMap> listImpactMaps(const LegendChoice& legend = {});

}  // namespace noonmark
