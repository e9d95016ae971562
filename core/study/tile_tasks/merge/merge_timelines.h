#pragma once

#include <stop_token>

#include "core/study/tile_tasks/merge/merge_tiles.h"

namespace noonmark {

/// Joins the finished tiles of a plan of timelines, into the folder `merged` of the plan: `timelines.jsonl`,
/// a line of JSON for each place as of timelineJson(), and `timelines.csv`, a row for each place and day:
/// place, kind, source, day, area_m2, sunlit_min, theoretical_m2h, full_cover_min, all_sun_taken_min, and
/// enters, exits, duration_min, largest_m2, largest_at, area_hours_m2h, longest_stay_min of each kind of
/// shadow (baseline_enters, ...); of the baseline alone where there is no scenario. A place that lies at the
/// edge of two districts is taken from the first. Existing files of an earlier merge are replaced. Holds one
/// tile in memory. Error: tiles are missing, unless `partial`; a file cannot be read or written; cancelled().
Result<MergeReport> mergeTimelines(const std::filesystem::path& folder, const TaskPlan& plan, bool partial,
                                   Progress& progress, const std::stop_token& stop);

}  // namespace noonmark
