#pragma once

// What is said of the sun of places as hours of sun, or as minutes of shadow: the rest of the sunlit time.
// Days that are named keep hours of sun.

#include <functional>

#include "core/describe/shown_as.h"
#include "core/study/by_place/sun_by_place.h"

namespace noonmark {

/// Hours a day with the sun above the horizon on the days that `has` names; NaN: the period has none of them,
/// or its days are not known, as of a saved answer.
double possibleHoursOn(const SunByPlace& sun, const std::function<bool(const CivilDate&)>& has);

/// As makePage() of sun_by_place.h.
AnswerPage makePage(const SunOfCities& sun, ShownAs show);
AnswerPage makePage(const SunOfCities& sun, std::size_t place, ShownAs show);

}  // namespace noonmark
