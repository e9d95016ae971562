#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "core/engines/trees/crowns.h"
#include "core/measures/places/place_receivers.h"
#include "core/measures/places/place_run.h"
#include "core/study/review_study.h"

namespace noonmark {

/// What is measured: the places, or the belts around parcels.
struct RulePlaces {
    std::vector<Place> places;
    std::vector<LineBelt> belts;
};

/// The city with the trees that a rule counts, weighed (Trees::weighed); without trees where it counts none
/// of them. `existing`: the city of the baseline.
City keepCountedTrees(RuleTrees counted, City city, const City& existing);

bool haveSameTrees(const City& one, const City& other);

/// "Trees: evergreen trees only"
std::string describeCountedTrees(RuleTrees counted);
/// What a review says of trees, a sentence: "Trees: evergreen trees only; 3 of the city's 12 trees count".
/// `city`: the scenario.
std::string describeCountedTrees(RuleTrees counted, const City& city, const City& existing);

/// Which trees stand in dense belts of evergreens: at least minBeltTrees that keep their leaves and let at
/// most maxBeltTransmissivity of the sun pass, each with its crown within maxBeltGapM of the next. The
/// figures are Noonmark's choice: no rule at hand states any. One entry a tree; n log n, and in a row of
/// crowns that touch those of the same width from west to east.
std::vector<std::uint8_t> findEvergreenBelts(const std::vector<Tree>& trees);
inline constexpr std::size_t minBeltTrees = 3;
inline constexpr float maxBeltTransmissivity = 0.2F;
inline constexpr double maxBeltGapM = 1;

/// The buildings whose shadows a rule counts.
struct CastingCities {
    City before, after;
};

/// All buildings; or, of a rule about the proposal's own shadow, those that the scenario adds or changes,
/// held against what they replace only where the rule's baseline is a body within the zoning. Of the trees
/// those that the rule counts (keepCountedTrees()).
CastingCities chooseCasters(const Rule& rule, const City& baseline, const City& scenario);

/// The cities that cast, and the cells on which they do.
struct RuleScene {
    City before, after;
    PlaceReceivers receivers;
    /// The ground without buildings, where only the proposal casts and there is terrain: its own shadow is
    /// nobody's, and counts neither before nor after.
    std::optional<City> bare{};
    std::optional<float> planeZ{};  ///< of a rule about a plane on which receivers were raised
    /// The crowns of both cities, whose shade counts at each step from half of the sun on.
    CrownMasks crownsBefore{}, crownsAfter{};
    std::vector<glm::vec3> origins{};  ///< of the receivers' rays; empty where there are no crowns
    [[nodiscard]] std::array<const City*, 2> cities() const { return {&before, &after}; }
};

/// A rule's question, ready to be computed.
struct PreparedReview {
    RuleSun days;
    RulePlaces measured;
    RuleScene scene;
};

/// How many points a review looks at on a day, in all places, for their worst spots (expectPoints()). New
/// shadow is looked for only where a building that comes or goes, or trees that do, can shade the place.
std::size_t expectSpotPoints(const Rule& rule, const PreparedReview& prepared);

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
