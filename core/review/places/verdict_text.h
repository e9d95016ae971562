#pragma once

#include <string>
#include <string_view>

#include "core/base/units.h"
#include "core/describe/text.h"
#include "core/review/places/place_review.h"

namespace noonmark {

/// Why nothing is judged where the sun is never up in a rule's hours: of places and windows alike.
inline constexpr std::string_view noSunInHours = NM_TEXT("No sun in these hours");
/// Why nothing is judged where a rule only asks for figures.
inline constexpr std::string_view noLimitForPlace = NM_TEXT("The rule states no limit for this place");

/// "2 h 15 min", "62.0 %", "1,204 m²": a value of a criterion for people. Areas are not rounded to hectares
/// or acres: a verdict may hang on them. These texts are in the language of the WordingScope around the call.
std::string formatMeasured(Measure measure, double value, UnitSystem units = UnitSystem::metric);

/// "<= 1 h"; ">= 0.8 x former" or "loss <= 4.0 %" for a limit relative to the baseline.
std::string describeLimit(const Criterion& criterion, const Limit& limit,
                          UnitSystem units = UnitSystem::metric);
/// All limits, joined by "or"; empty if the criterion has none.
std::string describeLimits(const Criterion& criterion, UnitSystem units = UnitSystem::metric);

/// A date in a sentence: formatText(), or as people write it.
using WriteDate = std::string (*)(CivilDate date);

/// What a criterion measured and wants: "At least 2 h of sun: 1 h 30 min (former 3 h) on 2026-01-20, wanted
/// >= 2 h". The result must have a value.
std::string describeResult(const Criterion& criterion, const CriterionResult& result,
                           UnitSystem units = UnitSystem::metric, WriteDate writeDate = formatText);

/// The verdict of a place in a word or two: its name, or "figures only" where the rule covers the place and
/// states no limit for it.
std::string_view nameVerdict(const PlaceReview& review);

/// The same of one criterion.
std::string_view nameResult(const Criterion& criterion, const CriterionResult& result);

/// The verdict on a place in a sentence without a full stop: "At least 2 h of sun: 45.0 % (former 60.0 %) on
/// 2026-03-21, wanted >= 50.0 % or >= 0.8 x former".
std::string describeReason(const PlaceReview& review, UnitSystem units = UnitSystem::metric,
                           WriteDate writeDate = formatText);

}  // namespace noonmark
