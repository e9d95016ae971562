#pragma once

#include "scenarios/impact/impact_text.h"
#include "scenarios/project/project.h"
#include "scenarios/weights/score_text.h"

namespace noonmark {

/// The project with a result in it; one of the same name is replaced. `scenario`: whose city the study is of.
Project withResult(Project project, const std::string& name, const std::string& scenario, const Study& study);
Project withResult(Project project, const std::string& name, const ImpactAnswer& answer);
Project withResult(Project project, const std::string& name, const ScoreAnswer& answer);

}  // namespace noonmark
