#include "core/study/tile_tasks/plan/tile_load.h"

#include <algorithm>

#include "core/engines/horizon/geometry/azimuth_bins.h"

namespace noonmark {

namespace {

// Measured on tiles of New York, loaded machine: docs/scale.md.
constexpr double secondsToReadABuilding = 100e-6;
constexpr double secondsToWriteACell = 0.25e-6;
constexpr double programBytes = 150e6;
constexpr double bytesOfABuilding = 10000;
constexpr double bytesOfAPoint = 600;
constexpr double bytesOfACell = 400;
constexpr double bytesOfAPost = 250;

double secondsOf(const std::string& engine, const EstimatedSeconds& seconds, bool level) {
    if (engine == "ray") return seconds.ray;
    if (engine == "projected") return seconds.projected;
    if (engine == "auto") return std::min(level ? seconds.projected : seconds.ray, seconds.horizon + 2);
    return seconds.horizon;
}

}  // namespace

TileCost estimateTile(const TileHalo& halo, const Grid& tile, const StudySettings& settings,
                      const SunSteps& sun, std::size_t terrainPosts, const EngineList& engines) {
    const bool level = terrainPosts == 0 && settings.receivers.places == ReceiverPlaces::ground;
    const EngineLoad load{.receivers = tile.size(),
                          .rows = std::size_t(tile.rows),
                          .cellAreaM2 = tile.cellAreaM2(),
                          .steps = sun.steps.size(),
                          .bins = binCount(sun, HorizonSweepSettings{}),
                          .buildings = halo.buildings,
                          .overhangTriangles = halo.overhangTriangles,
                          .terrainCells = terrainPosts,
                          .level = level};
    const EngineEntry* engine = findEngine(engines, settings.engine);
    const double engineBytes = engine == nullptr ? 0 : engine->info.bytesPerCell;
    const double readBytes = double(halo.buildings) * bytesOfABuilding + double(halo.points) * bytesOfAPoint;
    const double ownBytes = programBytes + double(tile.size()) * (bytesOfACell + engineBytes) +
                            double(terrainPosts) * bytesOfAPost +
                            2 * double(sun.steps.size()) * double(sizeof(SunStep));
    return {secondsOf(settings.engine, estimateSeconds(load), level) +
                double(halo.buildings) * secondsToReadABuilding + double(tile.size()) * secondsToWriteACell,
            ownBytes + readBytes, readBytes};
}

}  // namespace noonmark
