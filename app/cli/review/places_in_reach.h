#pragma once

#include <stop_token>
#include <vector>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/city/city.h"
#include "core/review/rule/rule.h"
#include "core/study/review_study.h"

namespace noonmark::cli {

/// Of these places, those that the rule covers and that the shadow of the proposal reaches in the rule's
/// hours, with the proposal tested as if it stood alone (core/measures/place_screening.h). Error: there is
/// none; a rule about parcels; errors of screenPlaces() and computeRuleSun().
Result<std::vector<Place>> choosePlacesInReach(const Rule& rule, const City& baseline, const City& scenario,
                                               const std::vector<Place>& places,
                                               const ReviewSettings& settings, Progress& progress,
                                               const std::stop_token& stop);

}  // namespace noonmark::cli
