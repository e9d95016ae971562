#include "core/study/study.h"

#include <fmt/format.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

#include "core/base/memory_guard.h"
#include "core/base/progress.h"
#include "core/city/city_position.h"
#include "core/describe/text.h"
#include "core/engines/common/engine_in_use.h"
#include "core/measures/error_sample.h"
#include "core/receivers/roof_receivers.h"
#include "core/study/study_cost.h"
#include "core/sun/zone_country.h"

namespace noonmark {

namespace {

// Runs one stage, stores its result in `place` and adds its duration to `study.seconds`.
template <class T, class Stage>
Result<void> timeStage(Study& study, const char* name, T& place, std::stop_token stop, Stage&& stage) {
    if (stop.stop_requested()) return cancelled();
    const Stopwatch watch;
    auto made = std::forward<Stage>(stage)();
    if (!made) return tl::make_unexpected(std::move(made).error());
    place = *std::move(made);
    study.seconds[name] += watch.seconds();
    return {};
}

Result<void> checkReceivers(const Study& study) {
    if (!study.receivers.cells.empty()) return {};
    if (study.settings.receivers.places == ReceiverPlaces::roofs)
        return failure(NM_TEXT("No cell of the region lies on a roof"), study.settings.region.name,
                       NM_TEXT("Choose a region with buildings, or smaller cells"));
    return failure(NM_TEXT("No cell of the region lies on open ground"), study.settings.region.name,
                   NM_TEXT("Choose a region outside buildings and water, or smaller cells"));
}

bool wantsBreakdown(const StudySettings& settings) { return settings.byMonth || settings.contributions; }

Result<void> breakDown(Study& study, const EngineInUse& engine, Progress& progress,
                       const std::stop_token& stop) {
    if (!wantsBreakdown(study.settings)) return {};
    const bool byBuilding = study.settings.contributions;
    const StepSets sets = study.settings.byMonth ? monthsOf(study.sun) : makeOneSet(study.sun);
    if (byBuilding && engine.attributionIsLessExact())
        study.warnings.push_back(
            {WarningKind::assumed,
             fmt::format("{} are those of the horizon sweep, which a sample shows to be off here",
                         study.settings.byMonth ? "months and contributions" : "contributions"),
             study.settings.region.name});
    return timeStage(study, "breakdown", study.breakdown, stop,
                     [&] { return engine.breakDown(study.city, sets, byBuilding, progress, stop); });
}

Result<void> shadeMonths(Study& study, Progress& progress, const std::stop_token& stop) {
    if (!study.settings.byMonth || !study.breakdown || !study.field.trees) return {};
    return timeStage(study, "trees", study.shadedMonths, stop, [&] {
        return shadeTreeSets(study.city, study.receivers, study.sun, *study.breakdown, study.settings.trees,
                             progress, stop);
    });
}

Result<void> divideAmongTrees(Study& study, Progress& progress, const std::stop_token& stop) {
    if (!study.settings.contributions || !study.field.trees) return {};
    return timeStage(study, "trees", study.byTree, stop, [&] {
        return traceTakenByTree(study.city, study.receivers, study.sun, progress, stop);
    });
}

Result<void> placeStudy(Study& study, const std::stop_token& stop) {
    const StudySettings& settings = study.settings;
    return timeStage(study, "receivers", study.receivers, stop,
                     [&] { return placeReceivers(study.city, settings.region, settings.receivers, stop); })
        .and_then([&] { return checkReceivers(study); })
        .and_then([&] {
            return timeStage(study, "sun", study.sun, stop, [&] {
                return computeDaylightSteps(settings.period, makeObserver(study), stop);
            });
        })
        .and_then([&] {
            study.terrainCoverage = computeTerrainCoverage(study.city, study.receivers, study.sun);
            return checkCoverage(study.terrainCoverage, settings.region.name);
        });
}

Result<void> accumulate(Study& study, EngineInUse& engine, Progress& progress, const std::stop_token& stop) {
    auto done = timeStage(study, "accumulate", study.field, stop,
                          [&] { return engine.accumulate(study.city, progress, stop); });
    if (study.field.engineKey.empty()) study.field.engineKey = study.settings.engine;
    if (!done || !study.city.trees) return done;
    return timeStage(study, "trees", study.field.trees, stop, [&] {
        return shadeTrees(study.city, study.receivers, study.sun, study.field, study.settings.trees, progress,
                          stop);
    });
}

bool wantsError(const Study& study) {
    return study.settings.errorSample.receivers > 0 && !study.byReference();
}

// A failure to measure the error does not fail the study; only a stop request ends it.
Result<void> measureError(Study& study, Progress& progress, const std::stop_token& stop) {
    study.error.reset();
    if (!wantsError(study)) return {};
    const Stopwatch watch;
    auto taken = takeError(sampleError(study.city, study.receivers, study.sun, study.field,
                                       study.settings.errorSample, progress, stop),
                           study.error, study.warnings);
    if (taken) study.seconds["error_sample"] += watch.seconds();
    return taken;
}

bool goesOn(const Study& study, EngineInUse& engine) {
    return study.error && engine.switchToMoreExact(study.error->grossOff());
}

// Of all months together, on a quarter of the sample.
Result<std::optional<ShownError>> compareMonths(const Study& study, const std::stop_token& stop) {
    const ShadowBreakdown& by = *study.breakdown;
    const std::size_t size = sampleSize(study.settings.errorSample, study.sun.steps.size());
    const auto cells =
        spreadReceivers(study.receivers, std::max<std::size_t>(1, size / 4), study.settings.errorSample.seed);
    NoProgress quiet;
    const auto compared = compareSets(study.city, study.receivers, study.sun, by, cells, quiet, stop);
    if (!compared) return tl::make_unexpected(compared.error());
    std::vector<double> off;
    for (std::size_t month = 0; month < by.sets.names.size(); ++month) {
        const auto days = double(by.sets.stepsOf(month, study.sun).dayCount());
        for (std::size_t cell = 0; days > 0 && cell < cells.size(); ++cell)
            off.push_back(std::abs(compared->minutes[month][cell] - compared->reference[month][cell]) / days);
    }
    if (off.empty()) return std::optional<ShownError>();
    return std::optional(sumUpError("cell_month", std::move(off)));
}

// As measureError().
Result<void> measureMonthError(Study& study, const std::stop_token& stop) {
    if (!study.settings.byMonth || !study.breakdown || !wantsError(study)) return {};
    const Stopwatch watch;
    auto error = compareMonths(study, stop);
    if (!error && isCancelled(error.error())) return tl::make_unexpected(error.error());
    if (!error)
        study.warnings.push_back(
            {WarningKind::leftOut, "the error of months against the ray reference", error.error().text()});
    if (error) study.monthError = *std::move(error);
    study.seconds["error_sample"] += watch.seconds();
    return {};
}

// By the engine in use, and by those that it goes on to while samples are off by more than it aims at.
Result<void> measureField(Study& study, EngineInUse& engine, Progress& progress,
                          const std::stop_token& stop) {
    do {
        if (auto done = accumulate(study, engine, progress, stop); !done) {
            if (!study.error || isCancelled(done.error())) return done;
            study.warnings.push_back(
                {WarningKind::leftOut, "a more exact engine, which failed", done.error().text()});
            return {};
        }
        if (auto done = measureError(study, progress, stop); !done) return done;
    } while (goesOn(study, engine));
    return breakDown(study, engine, progress, stop)
        .and_then([&] { return shadeMonths(study, progress, stop); })
        .and_then([&] { return divideAmongTrees(study, progress, stop); })
        .and_then([&] { return measureMonthError(study, stop); });
}

}  // namespace

std::vector<ShownError> listErrors(const Study& study) {
    std::vector<ShownError> errors;
    if (study.error) errors = listErrors(*study.error, false);
    if (study.monthError) errors.push_back(*study.monthError);
    return errors;
}

Observer makeObserver(const City& city, const StudySettings& settings) {
    const Box2 box = bounds(settings.region);
    Observer observer = placeObserver(city, glm::dvec2(box.low + box.high) / 2.0);
    observer.pressureHPa = settings.pressureHPa;
    observer.temperatureC = settings.temperatureC;
    return observer;
}

SunFrameFacts computeSunFrame(const City& city, const StudySettings& settings) {
    const Box2 box = bounds(settings.region);
    const glm::dmat3 turn = makeObserver(city, settings).frameFromPlace;
    const glm::dvec3 up = glm::normalize(glm::cross(turn[0], turn[1]));
    SunFrameFacts facts;
    facts.convergenceDeg = Radians{std::atan2(turn[1].x, turn[1].y)}.degrees().value;
    facts.tiltDeg = Radians{std::atan2(std::hypot(up.x, up.y), up.z)}.degrees().value;
    facts.farthestM = glm::length(glm::dvec2(box.high - box.low)) / 2;
    facts.verticalErrorDeg = computeVerticalErrorDeg(facts.farthestM);
    return facts;
}

Observer makeObserver(const Study& study) { return makeObserver(study.city, study.settings); }

namespace {

Result<Study> answer(const City& city, const StudySettings& settings, Progress& progress,
                     const std::stop_token& stop, const EngineList& engines) {
    const Stopwatch watch;
    const auto period = validate(settings.period);
    if (!period) return tl::make_unexpected(period.error());
    const auto engine = makeEngine(settings.engine, settings.engineSettings, engines);
    if (!engine) return tl::make_unexpected(engine.error());
    if (auto able = checkBreakdown(settings, (*engine)->capabilities(), engines); !able)
        return tl::make_unexpected(able.error());
    if (auto fits = checkMemory(city, settings, engines); !fits) return tl::make_unexpected(fits.error());

    Study study{.city = withTreesFor(city, settings.trees), .settings = settings};
    if (auto done = placeStudy(study, stop); !done) return tl::make_unexpected(done.error());
    const City* const cities[]{&study.city};
    EngineInUse inUse(**engine, cities, study.receivers, study.sun);
    if (auto done = measureField(study, inUse, progress, stop); !done)
        return tl::make_unexpected(done.error());
    study.statistics = computeStatistics(study.field);
    Warnings first = study.field.warnings;
    for (Warning& warning : makeWarnings(study.terrainCoverage)) first.push_back(std::move(warning));
    const Box2 box = bounds(settings.region);
    const LonLat middle = city.frame.lonLatFromLocal(glm::dvec2(box.low + box.high) / 2.0);
    if (auto question = questionZone(settings.period, middle)) first.push_back(*std::move(question));
    study.warnings.insert(study.warnings.begin(), first.begin(), first.end());
    study.seconds["total"] = watch.seconds();
    return study;
}

}  // namespace

Result<Study> runStudy(const City& city, const StudySettings& settings, Progress& progress,
                       std::stop_token stop, const EngineList& engines) {
    return guardMemory({.advice = "Choose larger cells, a smaller region or fewer steps"},
                       [&] { return answer(city, settings, progress, stop, engines); });
}

}  // namespace noonmark
