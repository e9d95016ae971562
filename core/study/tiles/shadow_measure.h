#pragma once

#include <optional>

#include "core/engines/common/engine_in_use.h"
#include "core/engines/ray/ray_scene.h"
#include "core/study/tiles/tile_runner.h"

namespace noonmark {

/// Gross and continuous shadow of a city, its months if the settings ask for them, and the error on a sample
/// of receivers. Holds a reference to the city.
class ShadowMeasure : public TileMeasure {
public:
    ShadowMeasure(const City& city, const TileQuestion& question);

    [[nodiscard]] std::vector<TileMap> maps() const override;
    Result<TileAnswer> measure(const Grid& tile, Progress& progress, const std::stop_token& stop) override;

private:
    Result<TileAnswer> computed(const Receivers& receivers, Progress& progress, const std::stop_token& stop);
    Result<ShadowField> accumulate(TileResult& result, EngineInUse& engine, const Receivers& receivers,
                                   Progress& progress, const std::stop_token& stop);
    Result<SampledDeviation> findOff(const TileResult& result, const EngineInUse& engine,
                                     const Receivers& receivers, const ShadowField& field, Progress& progress,
                                     const std::stop_token& stop) const;
    Result<void> addMonths(TileAnswer& answer, const EngineInUse& engine, Progress& progress,
                           const std::stop_token& stop) const;
    Result<void> compare(TileResult& result, const Receivers& receivers, const ShadowField& field,
                         Progress& progress, const std::stop_token& stop);

    const City& city_;
    TileQuestion question_;
    std::optional<RayScene> scene_;  ///< of the whole city; made when the first tile is compared
};

}  // namespace noonmark
