#pragma once

#include <stop_token>

#include "core/study/tile_tasks/plan/find_districts.h"
#include "core/study/tile_tasks/plan/tile_load.h"

namespace noonmark {

/// The occluders in and around a district, in coarse cells.
struct SurveyedDistrict {
    OccluderSurvey survey;
    City ground;  ///< frame and terrain; no buildings
    SunSteps sun;
    std::vector<Place> places{};  ///< to be measured: all of the file that are near the district
};

/// Sets the region of a district that has none to the box around all buildings, then surveys everything whose
/// shadow can reach the region: the buildings of the request's subject, or those of its files. By window, a
/// few square kilometres are in memory at a time. Errors of
/// readers, and a sun that never rises.
Result<SurveyedDistrict> surveyDistrict(District& district, const TaskPlanRequest& request,
                                        const InputsScan& scan, Progress& progress,
                                        const std::stop_token& stop);

}  // namespace noonmark
