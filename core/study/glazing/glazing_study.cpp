#include "core/study/glazing/glazing_study.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>

#include "core/base/memory_guard.h"
#include "core/base/progress.h"
#include "core/city/trees/tree.h"
#include "core/describe/text.h"
#include "core/geo/frame.h"
#include "core/review/glazing/glazing_review.h"
#include "core/study/review_study.h"

namespace noonmark {

namespace {

glm::dvec3 placeOf(const City& city, glm::dvec3 position) {
    const LonLat place = city.frame.lonLatFromLocal(glm::dvec2(position));
    const double drop = city.terrain ? earthDropM(glm::dvec2(position)) : 0;
    return {place.lonDeg, place.latDeg, position.z + city.frame.originElevationM() + drop};
}

void addAssumptions(const GlazingStudy& study, const PlacedElements& placed, Warnings& warnings) {
    const auto unknown =
        std::ranges::count_if(placed.facts, [](const GlazingFacts& facts) { return !facts.pane.isKnown(); });
    if (unknown == 0) return;
    const GlazingOpening& opening = study.rule.receivers.glazing.opening;
    warnings.push_back({WarningKind::assumed,
                        fmt::format("the size of the window is not stated; {:g} x {:g} m was taken",
                                    opening.widthM, opening.heightM),
                        fmt::format("{} windows", unknown)});
}

std::vector<std::string> listNotChecked(const Rule& rule, const City& city,
                                        const GlazingReviewSettings& settings) {
    std::vector<std::string> all = listUnchecked(rule, city);
    if (settings.elements.places == ElementPlaces::facades)
        all.emplace_back("Where the windows are: one was assumed in each bay and storey of the facades");
    if (const FaceChoice& faces = settings.elements.faces; !faces.takesAll())
        all.push_back(fmt::format("Windows other than these: {}", describe(faces)));
    return all;
}

void addPanes(const GlazingScene& scene, GlazingStudy& study) {
    const PointReceivers& receivers = scene.placed.receivers;
    for (std::size_t unit = 0; unit < scene.groups.size(); ++unit)
        for (const std::uint32_t window : scene.groups[unit])
            study.panes.push_back({{glm::dvec3(receivers.points.positions[window]),
                                    glm::dvec3(receivers.points.normals[window]),
                                    sizeOrOpening(scene.rule.receivers.glazing, scene.paneOf(window))},
                                   unit,
                                   receivers.elements[window].building});
}

Result<void> reviewAll(const GlazingScene& scene, GlazingStudy& study, Progress& progress,
                       const std::stop_token& stop) {
    const std::size_t count = scene.groups.size();
    study.windows.resize(count);
    study.places.resize(count);
    std::atomic<std::size_t> done{0};
    tbb::parallel_for(std::size_t{0}, count, [&](std::size_t i) {
        if (stop.stop_requested()) return;
        study.windows[i] = reviewGroup(scene, scene.groups[i]);
        study.places[i] =
            placeOf(scene.city, glm::dvec3(scene.placed.receivers.points.positions[scene.groups[i].front()]));
        progress.report(double(++done) / double(count), NM_TEXT("evaluating windows"));
    });
    if (stop.stop_requested()) return cancelled();
    return {};
}

void sumUp(GlazingStudy& study) {
    study.buildings = reviewBuildings(study.rule, study.windows);
    for (const GlazingReview& window : study.windows)
        study.windowChanges.add(window.formerVerdict, window.verdict);
    for (const BuildingReview& building : study.buildings)
        study.buildingChanges.add(building.formerVerdict, building.verdict);
}

// Some windows, evenly chosen among all, and the time of all by theirs.
Result<GlazingForecast> forecastOf(const GlazingScene& scene, const std::stop_token& stop) {
    constexpr std::size_t maxProbed = 64;
    const Stopwatch watch;
    const std::size_t count = scene.groups.size(), probed = std::min(count, maxProbed);
    tbb::parallel_for(std::size_t{0}, probed, [&](std::size_t i) {
        if (!stop.stop_requested()) reviewGroup(scene, scene.groups[i * count / probed]);
    });
    if (stop.stop_requested()) return cancelled();
    const double each = watch.seconds() / double(std::max<std::size_t>(probed, 1));
    return GlazingForecast{scene.placed.receivers.size(), scene.days.sun.steps.size(),
                           scene.prepareSeconds + scene.buildSeconds + double(count) * each};
}

GlazingStudy beginStudy(const GlazingScene& scene, const GlazingReviewSettings& settings) {
    GlazingStudy study{.rule = scene.rule,
                       .settings = settings,
                       .clock = scene.days.clock,
                       .year = scene.days.year,
                       .stepMinutes = scene.days.sun.stepMinutes,
                       .steps = scene.days.sun.steps.size(),
                       .notChecked = listNotChecked(scene.rule, scene.city, settings),
                       .warnings = scene.placed.warnings};
    study.engine = scene.engine;
    study.seconds["prepare"] = scene.prepareSeconds;
    study.seconds["build"] = scene.buildSeconds;
    addAssumptions(study, scene.placed, study.warnings);
    for (const Warning& warning : scene.days.warnings) study.warnings.push_back(warning);
    study.trees = scene.trees;
    return study;
}

Result<GlazingStudy> answerGlazing(const GlazingScene& scene, const GlazingReviewSettings& settings,
                                   Progress& progress, const std::stop_token& stop) {
    const Stopwatch evaluation;
    GlazingStudy study = beginStudy(scene, settings);
    if (auto done = reviewAll(scene, study, progress, stop); !done) return tl::make_unexpected(done.error());
    addPanes(scene, study);
    sumUp(study);
    study.seconds["evaluate"] = evaluation.seconds();
    study.seconds["total"] = scene.prepareSeconds + scene.buildSeconds + evaluation.seconds();
    return study;
}

constexpr const char* advice = "Choose fewer windows or buildings";

}  // namespace

Result<GlazingForecast> forecastGlazingReview(const Rule& rule, const City& baseline, const City& scenario,
                                              const GlazingReviewSettings& settings, Progress& progress,
                                              const std::stop_token& stop) {
    return guardMemory({.advice = advice}, [&] {
        return prepareGlazingScene(rule, baseline, scenario, settings, progress, stop)
            .and_then([&](const auto& scene) { return forecastOf(*scene, stop); });
    });
}

Result<GlazingStudy> runGlazingReview(const Rule& rule, const City& baseline, const City& scenario,
                                      const GlazingReviewSettings& settings, Progress& progress,
                                      const std::stop_token& stop, const AnnounceGlazing& announce) {
    return guardMemory({.advice = advice}, [&]() -> Result<GlazingStudy> {
        const auto scene = prepareGlazingScene(rule, baseline, scenario, settings, progress, stop);
        if (!scene) return tl::make_unexpected(scene.error());
        if (announce) {
            const auto forecast = forecastOf(**scene, stop);
            if (!forecast) return tl::make_unexpected(forecast.error());
            announce(*forecast);
        }
        return answerGlazing(**scene, settings, progress, stop);
    });
}

}  // namespace noonmark
