#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "core/study/place_study.h"
#include "core/sun/civil_time.h"

namespace noonmark {

/// What the timeline of a place is stated with.
struct TimelineLabels {
    std::string from;  ///< name of the baseline
    std::string to;    ///< name of the scenario; empty: the baseline alone
    Zone zone;         ///< for the times
};

/// One place as JSON (docs/user/places.md lists the keys): of one day its steps and summary, of several days
/// a list of days and the sums by month and quarter. Scripts rely on `steps`: `at`, `baseline_m2`,
/// `scenario_m2`, `incremental_m2`. Areas in m2, rounded to the cm2; times in ISO 8601 with offset.
nlohmann::ordered_json timelineJson(const PlaceStudy& study, const PlaceTimeline& place,
                                    const TimelineLabels& labels);

/// All places as CSV, one row for each place and step: place, day, at, baseline_m2, scenario_m2,
/// incremental_m2, gained_m2.
std::string timelineCsv(const PlaceStudy& study, const TimelineLabels& labels);

}  // namespace noonmark
