#pragma once

#include <stop_token>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/study/tiles/tile_maps.h"
#include "core/study/tiles/tile_result.h"

namespace noonmark {

/// The answer for one tile.
struct TileAnswer {
    TileResult result;  ///< without its number and its time
    /// The values of the bands of all maps, each in grid order; none if the tile has no receiver
    std::vector<std::vector<float>> bands{};
    /// Lines of JSON instead, of a measure without maps: TileResult::lines of them
    std::string lines{};
};

/// What is measured in the tiles of a study.
class TileMeasure {
public:
    virtual ~TileMeasure() = default;

    /// The bands of a tile's file.
    [[nodiscard]] virtual std::vector<TileMap> maps() const = 0;

    /// Measures the cells of `tile`, a part of the study's grid. cancelled() when stopped.
    virtual Result<TileAnswer> measure(const Grid& tile, Progress& progress, const std::stop_token& stop) = 0;
};

/// What a measure works with. Holds references, which must outlive it.
struct TileQuestion {
    const StudySettings& settings;
    const SunSteps& sun;
    const Engine& engine;
    Grid whole;  ///< of which the tiles are parts
};

}  // namespace noonmark
