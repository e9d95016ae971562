#include "core/study/place_study.h"

#include <tbb/parallel_for.h>

#include "core/base/memory_guard.h"
#include "core/city/trees/tree.h"
#include "core/measures/places/place_run.h"

namespace noonmark {

namespace {

std::optional<LonLat> locate(const std::optional<LongestStay>& stay, const PlaceReceivers& cells,
                             std::size_t place, const Frame& frame) {
    if (!stay) return std::nullopt;
    const std::uint32_t cell = cells.receivers.cells[cells.receiverOf(place, stay->cell)];
    return frame.lonLatFromLocal(glm::dvec2(cells.receivers.position(cell)));
}

void warnOfEmptyPlaces(const PlaceReceivers& cells, PlaceStudy& study) {
    for (std::size_t i = 0; i < study.places.size(); ++i)
        if (cells.cellCount(i) == 0)
            study.warnings.push_back({WarningKind::leftOut,
                                      "the place has no open ground as large as a cell; choose smaller cells",
                                      study.places[i].place.name});
}

Result<PlaceStudy> computePlaceStudy(const City& baseline, const City* scenario,
                                     const std::vector<Place>& places, const PlaceStudySettings& settings,
                                     const Engine& engine, Progress& progress, std::stop_token stop) {
    std::vector<const City*> cities{&baseline};
    if (scenario != nullptr) cities.push_back(scenario);
    const auto cells = placeReceiversOnPlaces(cities, places, {.cellM = settings.cellM}, stop);
    if (!cells) return tl::make_unexpected(cells.error());
    const auto period = validate(settings.period);
    if (!period) return tl::make_unexpected(period.error());
    const auto sun = computeDaylightSteps(*period, observerOfPlaces(baseline), stop);
    if (!sun) return tl::make_unexpected(sun.error());
    PlaceStudy study{.engine = std::string(engine.nameOfMasks(cities, cells->receivers)),
                     .cellM = settings.cellM};
    study.stepMinutes = sun->stepMinutes;
    for (const Place& place : places) study.places.push_back({.place = place});
    study.warnings = warnOfTrees(baseline.trees);
    warnOfEmptyPlaces(*cells, study);
    const TimelineSettings wanted{settings.allSteps, settings.longestStays};
    const auto take = [&](std::size_t, std::span<const PlaceShadow> shadows) -> Result<void> {
        tbb::parallel_for(std::size_t{0}, shadows.size(), [&](std::size_t i) {
            PlaceTimeline& timeline = study.places[i];
            timeline.days.push_back(computeTimeline(shadows[i], wanted));
            const DayTimeline& day = timeline.days.back();
            timeline.sums.add(day);
            timeline.longestIncrementalAt.push_back(
                locate(day.incremental.longest, *cells, i, baseline.frame));
        });
        return {};
    };
    if (auto done = shadePlaces(engine, baseline, scenario, *cells, *sun, take, progress, std::move(stop));
        !done)
        return tl::make_unexpected(done.error());
    return study;
}

}  // namespace

Result<PlaceStudy> runPlaceStudy(const City& baseline, const City* scenario, const std::vector<Place>& places,
                                 const PlaceStudySettings& settings, const Engine& engine, Progress& progress,
                                 std::stop_token stop) {
    return guardMemory({.what = "timelines of places"}, [&] {
        return computePlaceStudy(baseline, scenario, places, settings, engine, progress, std::move(stop));
    });
}

}  // namespace noonmark
