#pragma once

#include <array>
#include <stop_token>
#include <vector>

#include "core/measures/place_receivers.h"
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
    [[nodiscard]] std::array<const City*, 2> cities() const { return {&before, &after}; }
};

/// A rule's question, ready to be computed.
struct PreparedReview {
    RuleSun days;
    RulePlaces measured;
    RuleScene scene;
};

/// The sun, the places and the cells of a rule, and the cities that cast by it. Error: a rule about windows,
/// the sun below the horizon in all hours of the rule, and no place.
Result<PreparedReview> prepareReview(const Rule& rule, const City& baseline, const City& scenario,
                                     const std::vector<Place>& places, const ReviewSettings& settings,
                                     const std::stop_token& stop);

}  // namespace noonmark
