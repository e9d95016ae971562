#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/base/warnings.h"
#include "core/city/city.h"
#include "core/engines/api/engine.h"
#include "core/engines/api/tree_shade.h"
#include "core/measures/places/place_sums.h"
#include "core/measures/places/place_timeline.h"
#include "core/receivers/place.h"
#include "core/sun/civil_time.h"
#include "core/sun/period.h"

namespace noonmark {

struct PlaceStudySettings {
    Period period;
    double cellM = 1;          ///< 0.25 to 10
    bool allSteps = true;      ///< hold the areas of every step of every day (40 bytes each)
    bool longestStays = true;  ///< and the longest stay at one spot of every day
    /// Which shade of trees is measured, too; where it is none, a warning says so of a city with trees.
    TreeColumns trees = TreeColumns::without;
};

/// The days of a period on a place.
struct PlaceDays {
    std::vector<DayTimeline> days;
    PlaceSums sums;
    /// Where the longest stay of incremental shadow is, of each day, degrees; none without one.
    std::vector<std::optional<LonLat>> longestIncrementalAt;
};

/// The same with trees of one column (PlaceTrees).
struct ShadedPlace : PlaceDays {
    TreeColumns column = TreeColumns::seasonal;  ///< or evergreen
};

/// A place's shadow over the days of a period.
struct PlaceTimeline : PlaceDays {
    Place place;
    std::vector<ShadedPlace> withTrees{};  ///< evergreens first; empty: no tree reaches a place
};

struct PlaceStudy {
    std::vector<PlaceTimeline> places;  ///< in the order given
    std::string engine;                 ///< "Projected shadows"
    double cellM = 1;
    double stepMinutes = 1;
    Warnings warnings;          ///< places without a cell, trees that were not measured
    std::size_t treesUsed = 0;  ///< trees whose shadow can reach a place
};

/// The timelines of places in a baseline and in a scenario (null: the baseline alone). The sun is that of the
/// city's middle (observerOfPlaces()). Days without sun are listed with no steps. Error: no place, a period
/// out of range, the sun below the horizon at all steps; errors of Engine::shadeSteps(); cancelled().
Result<PlaceStudy> runPlaceStudy(const City& baseline, const City* scenario, const std::vector<Place>& places,
                                 const PlaceStudySettings& settings, const Engine& engine, Progress& progress,
                                 std::stop_token stop);

/// What the timeline of a place is stated with.
struct TimelineLabels {
    std::string from;  ///< name of the baseline
    std::string to;    ///< name of the scenario; empty: the baseline alone
    Zone zone;         ///< for the times
};

/// One place as JSON (docs/user/places.md lists the keys): of one day its steps and summary, of several days
/// a list of days and the sums by month and quarter. With trees all of these again, with the column at the
/// end of their keys: `baseline_m2_evergreen` of a step, `enters_seasonal` of a day, `scenario_m2h_seasonal`
/// of sums. Scripts rely on `steps`: `at`, `baseline_m2`, `scenario_m2`, `incremental_m2`. Areas in m2,
/// rounded to the cm2; times in ISO 8601 with offset.
nlohmann::ordered_json timelineJson(const PlaceStudy& study, const PlaceTimeline& place,
                                    const TimelineLabels& labels);

/// All places as CSV, one row for each place and step: place, day, at, baseline_m2, scenario_m2,
/// incremental_m2, gained_m2, and the areas with trees.
std::string timelineCsv(const PlaceStudy& study, const TimelineLabels& labels);

}  // namespace noonmark
