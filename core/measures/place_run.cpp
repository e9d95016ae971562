#include "core/measures/place_run.h"

#include <tbb/parallel_for.h>

#include "core/city/city_observer.h"

namespace noonmark {

Observer observerOfPlaces(const City& city) { return placeObserver(city, {0, 0}); }

Result<void> shadePlaces(const Engine& engine, const City& baseline, const City* scenario,
                         const PlaceReceivers& places, const SunSteps& sun, const TakePlaces& take,
                         Progress& progress, std::stop_token stop) {
    std::vector<const City*> cities{&baseline};
    if (scenario != nullptr) cities.push_back(scenario);
    std::vector<PlaceShadow> shadows(places.cellsOf.size());
    const auto takeDay = [&](std::size_t day, std::span<StepMasks> masks) -> Result<void> {
        const SunDay& at = sun.days[day];
        tbb::parallel_for(std::size_t{0}, shadows.size(), [&](std::size_t i) {
            PlaceShadow& shadow = shadows[i];
            shadow.day = at.date;
            shadow.steps = std::span(sun.steps).subspan(at.first, at.count);
            shadow.cellAreaM2 = places.receivers.grid.cellAreaM2();
            shadow.stepMinutes = sun.stepMinutes;
            chooseReceivers(masks.front(), places.cellsOf[i], shadow.baseline);
            if (scenario != nullptr)
                chooseReceivers(masks.back(), places.cellsOf[i], shadow.scenario);
            else
                shadow.scenario = shadow.baseline;
        });
        return take(day, shadows);
    };
    return engine.shadeSteps(cities, places.receivers, sun, takeDay, progress, std::move(stop));
}

}  // namespace noonmark
