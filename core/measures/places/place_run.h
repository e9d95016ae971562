#pragma once

#include <functional>
#include <span>
#include <stop_token>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/city/city.h"
#include "core/engines/api/engine.h"
#include "core/measures/places/place_cells.h"
#include "core/measures/places/place_receivers.h"
#include "core/sun/solar_position.h"

namespace noonmark {

/// The observer whose sun all places of a city share: at the frame's origin, in the middle of the data. A
/// place has the same figures alone as among others; 5 km away the sun stands 0.05 deg off.
Observer observerOfPlaces(const City& city);

/// Takes one day: the shadow on every place, in the order of PlaceReceivers::cellsOf. `day`: index in
/// SunSteps::days. An error ends the run and is returned from it.
using TakePlaces = std::function<Result<void>(std::size_t day, std::span<const PlaceShadow> places)>;

/// Shadow on places, one day after the other in time order, so that a year is never held in memory.
/// `scenario` may be null: the places then have the baseline's shadow in both. The receivers are those of
/// placeReceiversOnPlaces() for these cities. Errors of Engine::shadeSteps() and of `take`.
Result<void> shadePlaces(const Engine& engine, const City& baseline, const City* scenario,
                         const PlaceReceivers& places, const SunSteps& sun, const TakePlaces& take,
                         Progress& progress, std::stop_token stop);

/// Makes two masks of those of several cities: the first becomes the baseline's, the last the scenario's.
using JoinMasks = std::function<void(std::span<StepMasks> ofCities)>;

/// The same with several cities, whose masks are joined first: shadow that is already cast by
/// one of two, or by the bare ground.
Result<void> shadePlaces(const Engine& engine, std::span<const City* const> cities, const JoinMasks& join,
                         const PlaceReceivers& places, const SunSteps& sun, const TakePlaces& take,
                         Progress& progress, std::stop_token stop);

/// Adds the shadow of masks of equal size, or takes it away.
void addShadow(StepMasks& to, const StepMasks& more);
void removeShadow(StepMasks& from, const StepMasks& less);

}  // namespace noonmark
