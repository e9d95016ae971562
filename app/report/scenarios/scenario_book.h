#pragma once

#include "app/report/book/book.h"
#include "app/report/scenarios/scenario_study.h"

namespace noonmark {

/// The legend of the scenario with most shadow at any receiver, which the maps of all of them share.
Legend commonLegend(const ScenarioStudies& scenarios, const LegendChoice& choice);

/// The book of several scenarios: their maps side by side with what each builds, their figures in one table,
/// a page of charts for each figure of months (scenario_months.h), then a page for each scenario with its map
/// of gross shadow, all on the scale of the largest value. `scenarios`, at least one, must outlive the book.
Book makeScenarioBook(const ScenarioStudies& scenarios, const BookSettings& settings);

}  // namespace noonmark
