#pragma once

#include <optional>

#include "core/engines/common/engine_in_use.h"
#include "core/engines/ray/ray_scene.h"
#include "core/study/tiles/tile_runner.h"

namespace noonmark {

/// Gross and continuous shadow of a city, its months if the settings ask for them, both with the trees that
/// they ask for, and the error on a sample of receivers.
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
    Result<std::optional<ShadowBreakdown>> breakDown(const EngineInUse& engine, Progress& progress,
                                                     const std::stop_token& stop) const;
    /// Adds what trees make of the field and of its months, if they reach a receiver.
    Result<void> addTrees(TileAnswer& answer, ShadowField& field,
                          const std::optional<ShadowBreakdown>& months, const Receivers& receivers,
                          Progress& progress, const std::stop_token& stop) const;
    [[nodiscard]] TreeColumns columns() const;
    Result<void> compare(TileResult& result, const Receivers& receivers, const ShadowField& field,
                         Progress& progress, const std::stop_token& stop);

    City city_;  ///< with its trees weighed, if they are wanted
    TileQuestion question_;
    std::optional<RayScene> scene_;  ///< of the whole city; made when the first tile is compared
};

}  // namespace noonmark
