#pragma once

#include <stop_token>

#include "core/study/tile_tasks/task_status.h"
#include "core/study/tiles/by_place_measure.h"

namespace noonmark {

/// The sun of all places of a plan.
struct MergedSun {
    SunOfCities sun;  ///< without fields and cells; provenance and how places were chosen are the caller's
    std::size_t missingTiles = 0;
};

/// Joins the finished tiles of a plan of sun by place into the answer that compareSunByPlace() gives to all
/// places at once: the same figures, but for rounding, under the same engine, with places in the order in
/// which they are read. Errors are means by the values compared, and the largest of the tiles. `study`: the
/// settings that were planned for, without region. `cities`: as many as the request names, of which only the
/// ground is needed; `city` of the answer. A place that lies at the edge of two districts is taken from the
/// first; those of further districts are in the frame of the first. Error: tiles are missing, unless
/// `partial`: their places are then left out, with a warning; a file cannot be read; cancelled().
Result<MergedSun> mergeSunByPlace(const std::filesystem::path& folder, const TaskPlan& plan,
                                  const ByPlaceRequest& request, const StudySettings& study,
                                  const std::vector<City>& cities, bool partial, Progress& progress,
                                  const std::stop_token& stop);

}  // namespace noonmark
