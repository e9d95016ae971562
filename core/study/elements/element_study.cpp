#include "core/study/elements/element_study.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <utility>

#include "core/base/memory_guard.h"
#include "core/base/stopwatch.h"
#include "core/io/files/fold_text.h"
#include "core/receivers/points/plane_points.h"
#include "core/study/elements/element_sample.h"

namespace noonmark {

namespace {

bool isNamed(const Building& building, const std::string& folded) {
    if (foldText(building.sourceId) == folded || foldText(building.name) == folded) return true;
    return std::ranges::any_of(building.parts,
                               [&](const Part& part) { return foldText(part.sourceId) == folded; });
}

std::string namesContaining(const City& city, const std::vector<std::uint32_t>& candidates,
                            const std::string& folded) {
    std::string names;
    int count = 0;
    for (const std::uint32_t index : candidates) {
        const std::string& name = city.buildings[index]->name;
        if (name.empty() || foldText(name).find(folded) == std::string::npos) continue;
        names += (names.empty() ? "" : ", ") + name;
        if (++count == 5) break;
    }
    return names;
}

std::vector<std::uint32_t> buildingsNamed(const City& city, const std::vector<std::uint32_t>& candidates,
                                          const std::string& name) {
    std::vector<std::uint32_t> named;
    const std::string folded = foldText(name);
    for (const std::uint32_t index : candidates)
        if (!folded.empty() && isNamed(*city.buildings[index], folded)) named.push_back(index);
    return named;
}

tl::unexpected<Error> noBuilding(const City& city, const std::vector<std::uint32_t>& candidates,
                                 const std::string& name) {
    const std::string alike = namesContaining(city, candidates, foldText(name));
    return failure(fmt::format("The region has no building '{}'", name), "facades",
                   alike.empty() ? "Give the name or the id of a building whose middle is in the region"
                                 : "Names that contain it: " + alike);
}

std::vector<std::string> splitNames(const std::string& names) {
    std::vector<std::string> split;
    std::istringstream stream(names);
    for (std::string name; std::getline(stream, name, ',');) split.push_back(name);
    return split;
}

// A name may contain a comma: the whole text is tried first.
Result<std::vector<std::uint32_t>> chooseBuildings(const City& city, const Region& region,
                                                   const std::vector<std::string>& texts) {
    const std::vector<std::uint32_t> inRegion = findBuildingsIn(city, region);
    if (texts.empty()) return inRegion;
    std::vector<std::uint32_t> chosen;
    for (const std::string& text : texts) {
        const bool one = !buildingsNamed(city, inRegion, text).empty();
        for (const std::string& name : one ? std::vector{text} : splitNames(text)) {
            const auto named = buildingsNamed(city, inRegion, name);
            if (named.empty()) return noBuilding(city, inRegion, name);
            chosen.insert(chosen.end(), named.begin(), named.end());
        }
    }
    std::ranges::sort(chosen);
    chosen.erase(std::unique(chosen.begin(), chosen.end()), chosen.end());
    return chosen;
}

Result<void> placeFacades(ElementStudy& study, const std::stop_token& stop) {
    return chooseBuildings(study.city, study.settings.region, study.elements.buildings)
        .and_then([&](const std::vector<std::uint32_t>& buildings) {
            return placeOnFacades(study.city, buildings, study.elements.facades, stop);
        })
        .map([&](PointReceivers placed) { study.receivers = std::move(placed); });
}

Result<void> placeAllWindows(ElementStudy& study, Progress& progress, const std::stop_token& stop) {
    const ElementSettings& elements = study.elements;
    auto read = readWindows(elements.windows, elements.windowFile, study.city, progress, stop);
    if (!read) return tl::make_unexpected(read.error());
    WindowsPlaced placed = placeWindows(study.city, study.settings.region, read->windows,
                                        {elements.facades.storeyM, elements.windowFile.aboveGround}, stop);
    if (stop.stop_requested()) return cancelled();
    study.receivers = std::move(placed.receivers);
    study.warnings = std::move(read->warnings);
    study.warnings.insert(study.warnings.end(), placed.warnings.begin(), placed.warnings.end());
    return {};
}

Result<void> placePlane(ElementStudy& study, const std::stop_token& stop) {
    auto plane = placeOnPlane(study.city, study.settings.region, study.settings.receivers,
                              study.elements.planeHeightM, stop);
    if (!plane) return tl::make_unexpected(plane.error());
    study.receivers = std::move(plane->receivers);
    study.planeM = plane->planeM;
    const auto leftOut = [&](std::size_t cells, const char* why) {
        if (cells > 0)
            study.warnings.push_back(
                {WarningKind::leftOut, why, fmt::format("{} cells of the plane", cells)});
    };
    leftOut(plane->insideBuildings, "the plane cuts a building there");
    leftOut(plane->belowGround, "the ground rises above the plane there");
    return {};
}

Result<void> placePoints(ElementStudy& study, Progress& progress, const std::stop_token& stop) {
    const Stopwatch watch;
    auto placed = study.elements.places == ElementPlaces::facades   ? placeFacades(study, stop)
                  : study.elements.places == ElementPlaces::windows ? placeAllWindows(study, progress, stop)
                                                                    : placePlane(study, stop);
    study.seconds["receivers"] = watch.seconds();
    if (!placed || study.receivers.size() > 0) return placed;
    const auto groups = groupWarnings(study.warnings);
    return failure(groups.empty()
                       ? fmt::format("The study has no points on {}", nameOf(study.elements.places))
                       : fmt::format("The study has no points: {}", lineOf(groups.front())),
                   study.settings.region.name,
                   "Choose a region with buildings, windows on their walls, or a higher plane");
}

Result<void> chooseEngine(ElementStudy& study) {
    const std::string& engine = study.settings.engine;
    if (engine != "auto" && engine != "horizon" && engine != referenceEngine)
        return unsupported(fmt::format("The engine '{}' does not measure points", engine), "engine",
                           "Choose one of: auto, horizon, ray");
    if (!study.settings.engineSettings.empty())
        return unsupported("Engines have no options for points", "engine", "Omit --option");
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

Result<void> measurePoints(ElementStudy& study, Progress& progress, const std::stop_token& stop) {
    const Stopwatch watch;
    auto minutes =
        study.engineKey == referenceEngine
            ? tracePoints(study.city, study.receivers.points, study.sun, progress, stop)
            : sweepPoints(study.city, study.receivers.points, study.sun, progress, stop, {.runs = true});
    if (!minutes) return tl::make_unexpected(minutes.error());
    study.minutes = *std::move(minutes);
    study.seconds["accumulate"] = watch.seconds();
    return {};
}

Result<void> measureElementError(ElementStudy& study, Progress& progress, const std::stop_token& stop) {
    if (study.engineKey == referenceEngine || study.settings.errorSample.receivers == 0) return {};
    const Stopwatch watch;
    const auto error = sampleElementError(study, progress, stop);
    if (!error) return tl::make_unexpected(error.error());
    study.error = *error;
    study.seconds["error_sample"] = watch.seconds();
    return {};
}

Result<ElementStudy> answerElements(const City& city, const StudySettings& settings,
                                    const ElementSettings& elements, Progress& progress,
                                    const std::stop_token& stop) {
    const Stopwatch watch;
    ElementStudy study{.city = city, .settings = settings, .elements = elements};
    const auto done = chooseEngine(study)
                          .and_then([&] { return checkPeriod(settings.period); })
                          .and_then([&] { return placePoints(study, progress, stop); })
                          .and_then([&] { return computeSun(study, stop); })
                          .and_then([&] { return measurePoints(study, progress, stop); })
                          .and_then([&] { return measureElementError(study, progress, stop); });
    if (!done) return tl::make_unexpected(done.error());
    study.seconds["total"] = watch.seconds();
    return study;
}

}  // namespace

std::string_view nameOf(ElementPlaces places) {
    return places == ElementPlaces::facades   ? "facades"
           : places == ElementPlaces::windows ? "windows"
                                              : "plane";
}

Result<ElementStudy> runElementStudy(const City& city, const StudySettings& settings,
                                     const ElementSettings& elements, Progress& progress,
                                     const std::stop_token& stop) {
    return guardMemory({.advice = "Choose fewer buildings, larger cells or fewer steps"},
                       [&] { return answerElements(city, settings, elements, progress, stop); });
}

}  // namespace noonmark
