#include "core/study/elements/place_elements.h"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>
#include <utility>

#include "core/io/files/fold_text.h"
#include "core/receivers/points/plane_points.h"

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

Result<PlacedElements> placeFacades(const City& city, const Region& region, const ElementSettings& elements,
                                    const std::stop_token& stop) {
    return chooseBuildings(city, region, elements.buildings)
        .and_then([&](const std::vector<std::uint32_t>& buildings) {
            return placeOnFacades(city, buildings, elements.facades, stop);
        })
        .map([&](PointReceivers placed) {
            return PlacedElements{std::move(placed), {}, 0, {}};
        });
}

Result<PlacedElements> placeAllWindows(const City& city, const Region& region,
                                       const ElementSettings& elements, Progress& progress,
                                       const std::stop_token& stop) {
    auto read = readWindows(elements.windows, elements.windowFile, city, progress, stop);
    if (!read) return tl::make_unexpected(read.error());
    WindowsPlaced placed = placeWindows(city, region, read->windows,
                                        {elements.facades.storeyM, elements.windowFile.aboveGround}, stop);
    if (stop.stop_requested()) return cancelled();
    PlacedElements all{std::move(placed.receivers), std::move(placed.facts), 0, std::move(read->warnings)};
    all.warnings.insert(all.warnings.end(), placed.warnings.begin(), placed.warnings.end());
    return all;
}

Result<PlacedElements> placePlane(const City& city, const StudySettings& settings, double heightM,
                                  const std::stop_token& stop) {
    auto plane = placeOnPlane(city, settings.region, settings.receivers, heightM, stop);
    if (!plane) return tl::make_unexpected(plane.error());
    PlacedElements all{std::move(plane->receivers), {}, plane->planeM, {}};
    const auto leftOut = [&](std::size_t cells, const char* why) {
        if (cells > 0)
            all.warnings.push_back({WarningKind::leftOut, why, fmt::format("{} cells of the plane", cells)});
    };
    leftOut(plane->insideBuildings, "the plane cuts a building there");
    leftOut(plane->belowGround, "the ground rises above the plane there");
    return all;
}

}  // namespace

std::string_view nameOf(ElementPlaces places) {
    return places == ElementPlaces::facades   ? "facades"
           : places == ElementPlaces::windows ? "windows"
                                              : "plane";
}

Result<PlacedElements> placeElements(const City& city, const StudySettings& settings,
                                     const ElementSettings& elements, Progress& progress,
                                     const std::stop_token& stop) {
    auto placed = elements.places == ElementPlaces::facades
                      ? placeFacades(city, settings.region, elements, stop)
                  : elements.places == ElementPlaces::windows
                      ? placeAllWindows(city, settings.region, elements, progress, stop)
                      : placePlane(city, settings, elements.planeHeightM, stop);
    if (!placed || placed->receivers.size() > 0) return placed;
    const auto groups = groupWarnings(placed->warnings);
    return failure(groups.empty() ? fmt::format("The study has no points on {}", nameOf(elements.places))
                                  : fmt::format("The study has no points: {}", lineOf(groups.front())),
                   settings.region.name,
                   "Choose a region with buildings, windows on their walls, or a higher plane");
}

}  // namespace noonmark
