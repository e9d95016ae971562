#include "core/study/elements/element_study.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "core/base/memory_guard.h"
#include "core/base/progress.h"
#include "core/describe/command_options.h"
#include "core/engines/points/point_sunlight.h"
#include "core/engines/shade_trees.h"
#include "core/study/study_fields.h"

namespace noonmark {

namespace {

// `off`: minutes of each point.
QuantityError quantityError(std::vector<double> off, double wholeMin) {
    QuantityError error;
    if (off.empty() || wholeMin <= 0) return error;
    std::ranges::sort(off);
    const double percent = 100 / wholeMin;
    const auto rank = std::size_t(std::ceil(0.99 * double(off.size()))) - 1;  // nearest rank
    error.meanPct = percent * std::accumulate(off.begin(), off.end(), 0.0) / double(off.size());
    error.p99Pct = percent * off[rank];
    error.largestPct = percent * off.back();
    return error;
}

}  // namespace

// The seed is spread over the fractions 0 to 1 by the golden ratio.
std::vector<std::size_t> choosePoints(std::size_t all, std::size_t count, std::uint32_t seed) {
    count = std::min(count, all);
    const double start = std::fmod(seed * 0.6180339887498949, 1.0);
    std::vector<std::size_t> chosen(count);
    for (std::size_t i = 0; i < count; ++i)
        chosen[i] = std::min(all - 1, std::size_t((double(i) + start) * double(all) / double(count)));
    return chosen;
}

SurfacePoints pointsAt(const SurfacePoints& all, const std::vector<std::size_t>& chosen) {
    SurfacePoints points;
    for (const std::size_t i : chosen) {
        points.positions.push_back(all.positions[i]);
        points.normals.push_back(all.normals[i]);
    }
    return points;
}

Result<ElementError> sampleElementError(const ElementStudy& study, const std::optional<RayScene>& scene,
                                        Progress& progress, const std::stop_token& stop) {
    const auto& sample = study.settings.errorSample;
    const auto chosen =
        choosePoints(study.receivers.size(), sampleSize(sample, study.sun.steps.size()), sample.seed);
    const auto truth =
        tracePoints(study.city, pointsAt(study.receivers.points, chosen), study.sun, progress, stop, scene);
    if (!truth) return tl::make_unexpected(truth.error());
    const double whole = study.minutes.possibleMin, longest = longestDayMinutes(study.sun);
    const PointMonths& swept = study.minutes;
    const auto compare = [&](double wholeMin, const auto& minutesOf) {
        std::vector<double> off;
        for (std::size_t i = 0; i < chosen.size(); ++i)
            off.push_back(std::abs(minutesOf(swept, chosen[i]) - minutesOf(*truth, i)));
        return quantityError(std::move(off), wholeMin);
    };
    ElementError error{.points = chosen.size(), .rays = truth->cost.rays};
    error.gross = compare(whole, [](const PointMonths& of, std::size_t point) { return of.sunlitOf(point); });
    error.continuous = compare(
        longest, [](const PointMonths& of, std::size_t point) { return double(of.longestShadowMin[point]); });
    error.longestSun = compare(
        longest, [](const PointMonths& of, std::size_t point) { return double(of.longestSunMin[point]); });
    return error;
}

namespace {

constexpr std::size_t sweptProbes = 256;  // enough for all cores: the sweep takes 64 points at a time
constexpr std::size_t tracedProbes = 16;

/// The time of work that has a part of its own and one for each point.
struct PointCost {
    double once = 0, each = 0;
    [[nodiscard]] double of(std::size_t points) const { return once + double(points) * each; }
};

PointCost costOf(const PointMonths& probe, const char* stage, std::size_t points) {
    return {probe.cost.seconds.at("build"),
            probe.cost.seconds.at(stage) / double(std::max<std::size_t>(points, 1))};
}

/// What trees take on top, of measured points.
struct TreeCost {
    PointCost cost;
    std::size_t trees = 0;
};

Result<TreeCost> measureTrees(const City& city, const StudySettings& settings, const SurfacePoints& points,
                              const SunSteps& sun, const PointMonths& without, ShadedStepFinder::By by,
                              Progress& progress, const std::stop_token& stop) {
    const City weighed = withTreesFor(city, settings.trees);
    if (!weighed.trees) return TreeCost{};
    const Stopwatch ofScene;
    if (const auto finder = ShadedStepFinder::over(weighed, sun, by, stop); !finder)
        return tl::make_unexpected(finder.error());
    const double once = ofScene.seconds();
    const Stopwatch watch;
    const auto shaded = shadeTreesAtPoints(weighed, points, sun, without, settings.trees, by, progress, stop);
    if (!shaded) return tl::make_unexpected(shaded.error());
    if (!*shaded) return TreeCost{};
    const double each =
        std::max(0.0, watch.seconds() - once) / double(std::max<std::size_t>(points.size(), 1));
    return TreeCost{{once, each}, (*shaded)->treesUsed};
}

SurfacePoints chooseProbes(const SurfacePoints& all, std::size_t count) {
    return pointsAt(all, choosePoints(all.size(), count, 0));
}

}  // namespace

Result<ElementForecast> forecastElementStudy(const City& city, const StudySettings& settings,
                                             const ElementSettings& elements, Progress& progress,
                                             const std::stop_token& stop) {
    const Stopwatch watch;
    const auto placed = placeElements(city, settings, elements, progress, stop);
    if (!placed) return tl::make_unexpected(placed.error());
    const auto sun = computeDaylightSteps(settings.period, makeObserver(city, settings), stop);
    if (!sun) return tl::make_unexpected(sun.error());
    const auto scene = RayScene::over(city, stop);
    if (!scene) return tl::make_unexpected(scene.error());
    const double prepared = watch.seconds();
    const SurfacePoints& all = placed->receivers.points;
    const SurfacePoints swept = chooseProbes(all, sweptProbes), traced = chooseProbes(all, tracedProbes);
    const auto horizons = sweepPoints(city, swept, *sun, progress, stop, {.runs = true, .scene = *scene});
    if (!horizons) return tl::make_unexpected(horizons.error());
    const auto rays = tracePoints(city, traced, *sun, progress, stop, *scene);
    if (!rays) return tl::make_unexpected(rays.error());
    const auto sweptTrees =
        measureTrees(city, settings, swept, *sun, *horizons, ShadedStepFinder::By::horizons, progress, stop);
    if (!sweptTrees) return tl::make_unexpected(sweptTrees.error());
    const auto tracedTrees =
        measureTrees(city, settings, traced, *sun, *rays, ShadedStepFinder::By::rays, progress, stop);
    if (!tracedTrees) return tl::make_unexpected(tracedTrees.error());
    const PointCost ofSweep = costOf(*horizons, "sweep", swept.size());
    const PointCost ofRays = costOf(*rays, "trace", traced.size());
    const std::size_t sample = std::min(all.size(), sampleSize(settings.errorSample, sun->steps.size()));
    return ElementForecast{all.size(), sun->steps.size(), sweptTrees->trees,
                           prepared + ofSweep.of(all.size()) + sweptTrees->cost.of(all.size()) +
                               (sample > 0 ? ofRays.of(sample) : 0),
                           prepared + ofRays.of(all.size()) + tracedTrees->cost.of(all.size())};
}

namespace {

Result<void> placePoints(ElementStudy& study, Progress& progress, const std::stop_token& stop) {
    const Stopwatch watch;
    auto placed = placeElements(study.city, study.settings, study.elements, progress, stop);
    if (!placed) return tl::make_unexpected(placed.error());
    study.receivers = std::move(placed->receivers);
    study.planeM = placed->planeM;
    study.warnings = std::move(placed->warnings);
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
Result<void> recomputeByRays(ElementStudy& study, const std::optional<RayScene>& scene, Progress& progress,
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

Result<void> shadePoints(ElementStudy& study, Progress& progress, const std::stop_token& stop) {
    const Stopwatch watch;
    const auto by =
        study.engineKey == referenceEngine ? ShadedStepFinder::By::rays : ShadedStepFinder::By::horizons;
    auto trees = shadeTreesAtPoints(study.city, study.receivers.points, study.sun, study.minutes,
                                    study.settings.trees, by, progress, stop);
    if (!trees) return tl::make_unexpected(trees.error());
    study.trees = *std::move(trees);
    if (study.trees) study.seconds["trees"] = watch.seconds();
    return {};
}

Result<ElementStudy> answerElements(const City& city, const StudySettings& settings,
                                    const ElementSettings& elements, Progress& progress,
                                    const std::stop_token& stop) {
    const Stopwatch watch;
    ElementStudy study{
        .city = withTreesFor(city, settings.trees), .settings = settings, .elements = elements};
    std::optional<RayScene> scene;
    const auto done = chooseEngine(study)
                          .and_then([&] { return checkPeriod(settings.period); })
                          .and_then([&] { return placePoints(study, progress, stop); })
                          .and_then([&] { return computeSun(study, stop); })
                          .and_then([&] { return makeScene(study, scene, stop); })
                          .and_then([&] { return measurePoints(study, scene, progress, stop); })
                          .and_then([&] { return measureElementError(study, scene, progress, stop); })
                          .and_then([&] { return recomputeByRays(study, scene, progress, stop); })
                          .and_then([&] { return shadePoints(study, progress, stop); });
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
