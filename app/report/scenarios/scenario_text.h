#pragma once

#include <string>

#include "app/report/scenarios/scenario_study.h"

namespace noonmark {

/// Columns: name,changes,receiver_area_m2,shadow_area_m2,shadow_area_change_m2,mean_gross_min,
/// mean_continuous_min,max_continuous_min,height_m,gross_floor_m2, those of the impact
/// (impact_baseline,impact_m2,impact_threshold_min,gained_m2,lost_m2), of the score
/// (weights,weighted_shade_m2h,score_m2), of the review (rule,rule_baseline,pass,borderline,fail,not_judged),
/// and the source columns (provenance_texts.h); one row per scenario. RFC 4180; fields are empty where
/// nothing was computed.
std::string scenariosCsv(const ScenarioStudies& scenarios);

/// Columns: scenario,use,storeys,gross_floor_m2; a row for each use in a scenario's towers, an empty use
/// where none is stated. RFC 4180.
std::string scenarioUsesCsv(const ScenarioStudies& scenarios);

/// The settings of the study, and figures and provenance of every scenario. Stable keys with their units.
/// `scenarios` has at least one. `failed`: listed with the reason.
std::string scenariosJson(const ScenarioStudies& scenarios, const FailedScenarios& failed = {});

}  // namespace noonmark
