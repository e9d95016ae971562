#include "core/measures/places/place_run.h"

#include <tbb/parallel_for.h>

#include "core/city/city_position.h"

namespace noonmark {

Observer observerOfPlaces(const City& city) { return placeObserver(city, {0, 0}); }

void addShadow(StepMasks& to, const StepMasks& more) {
    for (std::size_t i = 0; i < to.words.size(); ++i) to.words[i] |= more.words[i];
}

void removeShadow(StepMasks& from, const StepMasks& less) {
    for (std::size_t i = 0; i < from.words.size(); ++i) from.words[i] &= ~less.words[i];
}

Result<void> shadePlaces(const Engine& engine, const City& baseline, const City* scenario,
                         const PlaceReceivers& places, const SunSteps& sun, const TakePlaces& take,
                         Progress& progress, std::stop_token stop) {
    std::vector<const City*> cities{&baseline};
    if (scenario != nullptr) cities.push_back(scenario);
    return shadePlaces(
        engine, cities, [](const SunDay&, std::span<StepMasks>) {}, places, sun, take, progress,
        std::move(stop));
}

Result<void> shadePlaces(const Engine& engine, std::span<const City* const> cities, const JoinMasks& join,
                         const PlaceReceivers& places, const SunSteps& sun, const TakePlaces& take,
                         Progress& progress, std::stop_token stop) {
    std::vector<PlaceShadow> shadows(places.cellsOf.size());
    const auto takeDay = [&](std::size_t day, std::span<StepMasks> masks) -> Result<void> {
        const SunDay& at = sun.days[day];
        join(at, masks);
        tbb::parallel_for(std::size_t{0}, shadows.size(), [&](std::size_t i) {
            PlaceShadow& shadow = shadows[i];
            shadow.day = at.date;
            shadow.steps = std::span(sun.steps).subspan(at.first, at.count);
            shadow.cellAreaM2 = places.receivers.grid.cellAreaM2();
            shadow.stepMinutes = sun.stepMinutes;
            shadow.uneven = places.unevenOf[i];
            shadow.neighbours = places.neighboursOf[i];
            chooseReceivers(masks.front(), places.cellsOf[i], shadow.baseline);
            if (masks.size() > 1)
                chooseReceivers(masks.back(), places.cellsOf[i], shadow.scenario);
            else
                shadow.scenario = shadow.baseline;
        });
        return take(day, shadows);
    };
    return engine.shadeSteps(cities, places.receivers, sun, takeDay, progress, std::move(stop));
}

}  // namespace noonmark
