#include "app/cli/review/places_in_reach.h"

#include <algorithm>

#include "core/engines/auto_engine.h"
#include "core/measures/place_run.h"
#include "core/measures/place_screening.h"
#include "core/review/rule/rule_days.h"

namespace noonmark::cli {

namespace {

std::vector<Place> choosePlacesOfRule(const Rule& rule, const std::vector<Place>& places) {
    const auto& kinds = rule.receivers.kinds;
    std::vector<Place> covered;
    for (const Place& place : places)
        if (kinds.empty() || std::ranges::find(kinds, place.kind) != kinds.end()) covered.push_back(place);
    return covered;
}

}  // namespace

Result<std::vector<Place>> choosePlacesInReach(const Rule& rule, const City& baseline, const City& scenario,
                                               const std::vector<Place>& places,
                                               const ReviewSettings& settings, Progress& progress,
                                               const std::stop_token& stop) {
    if (rule.receivers.hasLines())
        return unsupported("The rule is about the surroundings of parcels", "--in-reach", "Name the lots");
    const std::vector<Place> covered = choosePlacesOfRule(rule, places);
    const auto sun = computeRuleSun(rule, {observerOfPlaces(baseline), settings.zone, settings.year}, stop);
    if (!sun) return tl::make_unexpected(sun.error());
    const auto screened =
        screenPlaces(baseline, scenario, covered, sun->sun, {}, AutoEngine(), progress, stop);
    if (!screened) return tl::make_unexpected(screened.error());
    std::vector<Place> reached;
    for (const ScreenedPlace& one : *screened)
        if (one.result == ScreeningResult::reached) reached.push_back(covered[one.place]);
    if (reached.empty())
        return failure("The proposal's shadow reaches no place in the rule's hours", "--in-reach",
                       "Run the rule without --in-reach to have that stated for each place");
    return reached;
}

}  // namespace noonmark::cli
