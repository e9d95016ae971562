#include "core/study/elements/element_study.h"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "core/base/memory_guard.h"
#include "core/base/progress.h"
#include "core/city/trees/tree.h"
#include "core/describe/command_options.h"
#include "core/study/elements/element_forecast.h"
#include "core/study/study_fields.h"

namespace noonmark {

namespace {

Result<void> placePoints(ElementStudy& study, Progress& progress, const std::stop_token& stop) {
    const Stopwatch watch;
    auto placed = placeElements(study.city, study.settings, study.elements, progress, stop);
    if (!placed) return tl::make_unexpected(placed.error());
    study.receivers = std::move(placed->receivers);
    study.planeM = placed->planeM;
    study.warnings = std::move(placed->warnings);
    std::ranges::move(warnOfTrees(study.city.trees), std::back_inserter(study.warnings));
    study.seconds["receivers"] = watch.seconds();
    return {};
}

Result<void> chooseEngine(ElementStudy& study) {
    const std::string& engine = study.settings.engine;
    if (engine != "auto" && engine != "horizon" && engine != referenceEngine)
        return unsupported(fmt::format("The engine '{}' does not measure points", engine), "engine",
                           "Choose one of: auto, horizon, ray");
    if (!study.settings.engineSettings.empty())
        return unsupported("Engines have no options for points", "engine",
                           fmt::format("Omit {}", flagOf(engineFields().rows(), "options")));
    study.engineKey = engine == referenceEngine ? std::string(referenceEngine) : "horizon";
    return {};
}

Result<void> checkPeriod(const Period& period) {
    if (const auto valid = validate(period); !valid) return tl::make_unexpected(valid.error());
    return {};
}

Result<void> computeSun(ElementStudy& study, const std::stop_token& stop) {
    const Stopwatch watch;
    auto sun = computeDaylightSteps(study.settings.period, makeObserver(study.city, study.settings), stop);
    if (!sun) return tl::make_unexpected(sun.error());
    study.sun = *std::move(sun);
    study.seconds["sun"] = watch.seconds();
    return {};
}

// One for the sweep, its sample and what goes on to rays.
Result<void> makeScene(const ElementStudy& study, std::optional<RayScene>& scene,
                       const std::stop_token& stop) {
    auto made = RayScene::over(study.city, stop);
    if (!made) return tl::make_unexpected(made.error());
    scene = *std::move(made);
    return {};
}

Result<void> measurePoints(ElementStudy& study, const std::optional<RayScene>& scene, Progress& progress,
                           const std::stop_token& stop) {
    const Stopwatch watch;
    auto minutes = study.engineKey == referenceEngine
                       ? tracePoints(study.city, study.receivers.points, study.sun, progress, stop, scene)
                       : sweepPoints(study.city, study.receivers.points, study.sun, progress, stop,
                                     {.runs = true, .scene = scene});
    if (!minutes) return tl::make_unexpected(minutes.error());
    study.minutes = *std::move(minutes);
    study.seconds["accumulate"] += watch.seconds();
    return {};
}

Result<void> measureElementError(ElementStudy& study, const std::optional<RayScene>& scene,
                                 Progress& progress, const std::stop_token& stop) {
    if (study.engineKey == referenceEngine || study.settings.errorSample.receivers == 0) return {};
    const Stopwatch watch;
    const auto error = sampleElementError(study, scene, progress, stop);
    if (!error) return tl::make_unexpected(error.error());
    study.error = *error;
    study.seconds["error_sample"] += watch.seconds();
    return {};
}

// By rays where "auto" swept horizons and a sample shows them to be off.
Result<void> goOnToRays(ElementStudy& study, const std::optional<RayScene>& scene, Progress& progress,
                        const std::stop_token& stop) {
    if (study.settings.engine != "auto" || !study.error || study.error->gross.meanPct <= pointErrorTargetPct)
        return {};
    study.whyRays = fmt::format(
        "a sample of the points by horizons is off by {:.3f} % of the sunlit time in the mean, more than the "
        "{:g} % aimed at",
        study.error->gross.meanPct, pointErrorTargetPct);
    study.engineKey = std::string(referenceEngine);
    study.error.reset();
    return measurePoints(study, scene, progress, stop);
}

Result<ElementStudy> answerElements(const City& city, const StudySettings& settings,
                                    const ElementSettings& elements, Progress& progress,
                                    const std::stop_token& stop) {
    const Stopwatch watch;
    ElementStudy study{.city = city, .settings = settings, .elements = elements};
    std::optional<RayScene> scene;
    const auto done = chooseEngine(study)
                          .and_then([&] { return checkPeriod(settings.period); })
                          .and_then([&] { return placePoints(study, progress, stop); })
                          .and_then([&] { return computeSun(study, stop); })
                          .and_then([&] { return makeScene(study, scene, stop); })
                          .and_then([&] { return measurePoints(study, scene, progress, stop); })
                          .and_then([&] { return measureElementError(study, scene, progress, stop); })
                          .and_then([&] { return goOnToRays(study, scene, progress, stop); });
    if (!done) return tl::make_unexpected(done.error());
    study.seconds["total"] = watch.seconds();
    return study;
}

}  // namespace

std::string describeEngine(const ElementStudy& study) {
    if (study.engineKey != referenceEngine) return "horizons of points";
    return study.whyRays.empty() ? "rays" : "rays, since " + study.whyRays;
}

std::string describe(const ElementError& error) {
    const auto text = [](const char* name, const QuantityError& of) {
        const std::string tail =
            std::isnan(of.p99Pct) ? "" : fmt::format("{:.3f} % at the 99th percentile, ", of.p99Pct);
        return fmt::format("{} {:.3f} % mean, {}{:.3f} % largest", name, of.meanPct, tail, of.largestPct);
    };
    std::string words = text("sunlit time", error.gross) + "; " + text("longest shadow", error.continuous);
    if (error.longestSun) words += "; " + text("longest sun", *error.longestSun);
    return words + fmt::format(", of {} points", error.points);
}

Result<ElementStudy> runElementStudy(const City& city, const StudySettings& settings,
                                     const ElementSettings& elements, Progress& progress,
                                     const std::stop_token& stop) {
    return guardMemory({.advice = "Choose fewer buildings, larger cells or fewer steps"},
                       [&] { return answerElements(city, settings, elements, progress, stop); });
}

}  // namespace noonmark
