#pragma once

#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/base/warnings.h"
#include "core/city/city.h"
#include "core/describe/field.h"
#include "core/engines/api/engine.h"
#include "core/measures/places/place_timeline.h"
#include "core/review/places/place_review.h"
#include "core/review/rule/rule.h"
#include "core/review/rule/rule_days.h"

namespace noonmark {

/// What a review of places or windows leaves unchecked: what the rule states, and what it asks of the city
/// that the city does not have.
std::vector<std::string> listUnchecked(const Rule& rule, const City& city);

struct ReviewSettings {
    double cellM = 1;  ///< 0.25 to 10
    std::string zone;  ///< IANA name
    int year = 2026;   ///< of rules that name none
    /// Hold the areas in shadow step by step, for charts. Of more than a month of days, steps that are at
    /// least ten minutes apart.
    bool timelines = false;
    bool contributions = false;  ///< of each new building, where there are 2 to maxContributors
    bool refinesSpots = true;    ///< look for the worst spots between the centres of cells too
};

/// What a user asks of a review beside rule, cities and places: year, zone and cells.
const Fields<ReviewSettings>& reviewFields();

/// More new buildings are not measured one by one: each costs as much as the review.
inline constexpr std::size_t maxContributors = 20;

/// The incremental shadow of one new building alone: in shadow in the scenario, lit in the baseline and in
/// the scenario without it. What a demolished building shaded before is nobody's.
struct ReviewContribution {
    std::string id, name;                ///< of the building
    std::vector<double> incrementalM2h;  ///< by place, over the rule's days, m2 x h
};

/// A rule's answers for all places.
struct ReviewStudy {
    Rule rule;
    ReviewSettings settings;
    std::vector<PlaceReview> places;  ///< in the order given; two for each parcel of a rule with lines
    /// One timeline for each place and day, without longest stays; empty unless the settings ask for them.
    std::vector<std::vector<DayTimeline>> timelines{};
    std::vector<ReviewContribution> contributions{};  ///< in the order of the scenario's buildings
    std::string engine;
    std::string clock;  ///< "America/New_York, standard time"
    int year = 0;
    double stepMinutes = 1;
    /// How near to each other the points are among which the worst spots were looked for, metres; none: only
    /// the centres of cells.
    std::optional<double> spotDistanceM;
    std::vector<std::string> notChecked;  ///< of the rule, and what this run adds to it
    Warnings warnings;
    std::string trees{};  ///< which trees count, and how many those are: a sentence without a full stop
};

/// Evaluates a rule on places. The baseline and the scenario are whole cities; where the rule says that only
/// the proposal casts, each keeps only the buildings that the other does not have. Of a rule with lines the
/// places are parcels: the belt between the lines, and what lies beyond the outer line as far as the limit
/// can be exceeded, are measured. Where the sun is not up in the rule's hours, no place is checked. Error: no
/// place, a rule about windows, errors of Engine::shadeSteps(), or cancelled().
Result<ReviewStudy> runReview(const Rule& rule, const City& baseline, const City& scenario,
                              const std::vector<Place>& places, const ReviewSettings& settings,
                              const Engine& engine, Progress& progress, std::stop_token stop);

/// The timelines behind the figures of a rule: the same cells, steps and hours.
struct RuleTimelines {
    std::vector<std::string> names;  ///< of what is measured: the places, or two belts for each parcel
    std::vector<std::vector<DayTimeline>> days;  ///< [place][day], with steps and without longest stays
    DayClock clock;
    double stepMinutes = 1;
};

/// The timelines of places on a rule's days, as runReview() measures them; the same errors. Each step takes
/// 40 bytes: choose the days and the step of `rule` accordingly.
Result<RuleTimelines> computeRuleTimelines(const Rule& rule, const City& baseline, const City& scenario,
                                           const std::vector<Place>& places, const ReviewSettings& settings,
                                           const Engine& engine, Progress& progress, std::stop_token stop);

/// The expected time of runReview() in seconds on two cores, by the model that chooses engines
/// (auto_engine.h). Errors as of runReview(). Costs what placing the cells does.
Result<double> estimateReviewSeconds(const Rule& rule, const City& baseline, const City& scenario,
                                     const std::vector<Place>& places, const ReviewSettings& settings,
                                     const std::stop_token& stop);

/// The city with only the buildings that `other` does not have. Buildings are the same if
/// they are shared or equal in every value.
City keepOwnBuildings(const City& city, const City& other);

}  // namespace noonmark
