#pragma once

#include <array>
#include <optional>
#include <stop_token>
#include <vector>

#include "core/measures/places/place_receivers.h"
#include "core/measures/places/place_run.h"
#include "core/study/review_study.h"

namespace noonmark {

/// What is measured: the places, or the belts around parcels.
struct RulePlaces {
    std::vector<Place> places;
    std::vector<LineBelt> belts;
};

/// The buildings whose shadows a rule counts.
struct CastingCities {
    City before, after;
};

/// All buildings; or, of a rule about the proposal's own shadow, those that the scenario adds or changes,
/// held against what they replace only where the rule's baseline is a body within the zoning.
CastingCities chooseCasters(const Rule& rule, const City& baseline, const City& scenario);

/// The cities that cast, and the cells on which they do.
struct RuleScene {
    City before, after;
    PlaceReceivers receivers;
    /// The ground without buildings, where only the proposal casts and there is terrain: its own shadow is
    /// nobody's, and counts neither before nor after.
    std::optional<City> bare{};
    std::optional<float> planeZ{};  ///< of a rule about a plane on which receivers were raised
    [[nodiscard]] std::array<const City*, 2> cities() const { return {&before, &after}; }
};

/// A rule's question, ready to be computed.
struct PreparedReview {
    RuleSun days;
    RulePlaces measured;
    RuleScene scene;
};

/// Shadow on the places of a review, one day after the other (shadePlaces()).
Result<void> shadeScene(const Engine& engine, const PreparedReview& prepared, const TakePlaces& take,
                        Progress& progress, std::stop_token stop);

/// The shadow of the scenario held against that of the baseline and of a city `without` some of the
/// scenario's buildings together: what falls on ground that both leave lit.
Result<void> shadeWithout(const Engine& engine, const PreparedReview& prepared, const City& without,
                          const TakePlaces& take, Progress& progress, std::stop_token stop);

/// The sun, the places and the cells of a rule, and the cities that cast by it. Error: a rule about windows,
/// and no place.
Result<PreparedReview> prepareReview(const Rule& rule, const City& baseline, const City& scenario,
                                     const std::vector<Place>& places, const ReviewSettings& settings,
                                     const std::stop_token& stop);

}  // namespace noonmark
