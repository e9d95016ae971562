#pragma once

#include <functional>
#include <span>
#include <stop_token>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/city/city.h"
#include "core/engines/api/engine.h"
#include "core/engines/trees/crowns.h"
#include "core/measures/places/place_cells.h"
#include "core/measures/places/place_receivers.h"
#include "core/measures/places/place_timeline.h"
#include "core/sun/solar_position.h"

namespace noonmark {

/// The observer whose sun all places of a city share: at the frame's origin, in the middle of the data. A
/// place has the same figures alone as among others; 5 km away the sun stands 0.05 deg off.
Observer observerOfPlaces(const City& city);

/// Weighs the crowns of the trees of one or two cities on places. `scenario` null: the places have the
/// baseline's crowns in both. The trees that are weighed are those that City::trees says. Holds references.
class PlaceTrees {
public:
    PlaceTrees(const City& baseline, const City* scenario, const PlaceReceivers& places, const SunSteps& sun);

    /// Trees whose shadow can reach a place, of the city that has more of them.
    [[nodiscard]] std::size_t treesUsed() const;

    /// One day of a place.
    struct Shaded {
        DayTimeline evergreen, seasonal;
    };
    /// The timeline of a place with trees. Areas at each step and area x hours are weighted by what buildings
    /// and crowns take from the sun at each cell; a cell's incremental shadow is what the scenario takes
    /// more. Times, longest stays and covers count a cell as shaded from TreeShade::defaultShadedFrom on.
    /// `without`: the same day with its steps. Some 10 ns for each lit cell and step and each crown near it,
    /// and what computeTimeline() costs, twice. Returns unfinished sums when stopped.
    [[nodiscard]] Shaded shade(std::size_t place, std::size_t day, const PlaceShadow& shadow,
                               const DayTimeline& without, const TimelineSettings& settings,
                               const std::stop_token& stop) const;

private:
    const PlaceReceivers& places_;
    const SunSteps& sun_;
    CrownScene before_, after_;
    bool differ_;
    std::vector<glm::dvec3> directions_;  // of the steps, unit vectors
    double lowestTan_ = 1e9;
};

/// Takes one day: the shadow on every place, in the order of PlaceReceivers::cellsOf. `day`: index in
/// SunSteps::days. An error ends the run and is returned from it.
using TakePlaces = std::function<Result<void>(std::size_t day, std::span<const PlaceShadow> places)>;

/// Shadow on places, one day after the other in time order, so that a year is never held in memory.
/// `scenario` may be null: the places then have the baseline's shadow in both. The receivers are those of
/// placeReceiversOnPlaces() for these cities. Errors of Engine::shadeSteps() and of `take`.
Result<void> shadePlaces(const Engine& engine, const City& baseline, const City* scenario,
                         const PlaceReceivers& places, const SunSteps& sun, const TakePlaces& take,
                         Progress& progress, std::stop_token stop);

/// Makes two masks of those of several cities on a day: the first becomes the baseline's, the last the
/// scenario's.
using JoinMasks = std::function<void(const SunDay& day, std::span<StepMasks> ofCities)>;

/// The same with several cities, whose masks are joined first: shadow that is already cast by
/// one of two, or by the bare ground.
Result<void> shadePlaces(const Engine& engine, std::span<const City* const> cities, const JoinMasks& join,
                         const PlaceReceivers& places, const SunSteps& sun, const TakePlaces& take,
                         Progress& progress, std::stop_token stop);

/// Adds the shadow of masks of equal size, or takes it away.
void addShadow(StepMasks& to, const StepMasks& more);
void removeShadow(StepMasks& from, const StepMasks& less);

}  // namespace noonmark
