#pragma once

#include <optional>
#include <stop_token>

#include "core/engines/ray/ray_scene.h"
#include "core/receivers/tile_plan.h"
#include "core/study/study.h"
#include "core/study/tiles/tile_journal.h"

namespace noonmark {

/// Computes the tiles of a study one by one and stores them in a journal. Holds references to its arguments,
/// which must outlive it.
class TileRunner {
public:
    TileRunner(const City& city, const StudySettings& settings, const SunSteps& sun, const Engine& engine,
               const TilePlan& plan, TileJournal& journal);

    /// Writes the tile's cells to its file and its numbers to the journal. `contentHash`: stored with the
    /// tile, and if it is not empty, so are the size and the hash of its file.
    Result<void> run(std::size_t tile, Progress& progress, const std::stop_token& stop,
                     const std::string& contentHash = {});

private:
    Result<TileResult> computed(std::size_t tile, const Receivers& receivers, Progress& progress,
                                const std::stop_token& stop);
    Result<void> compare(TileResult& result, const Receivers& receivers, const ShadowField& field,
                         Progress& progress, const std::stop_token& stop);

    const City& city_;
    const StudySettings& settings_;
    const SunSteps& sun_;
    const Engine& engine_;
    const TilePlan& plan_;
    TileJournal& journal_;
    std::optional<RayScene> scene_;  ///< of the whole city; made when the first tile is compared
};

}  // namespace noonmark
