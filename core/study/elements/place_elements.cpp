#include "core/study/elements/place_elements.h"

#include <fmt/format.h>
#include <algorithm>
#include <sstream>
#include <utility>

#include "core/base/safe_text.h"
#include "core/base/warnings.h"
#include "core/city/city.h"
#include "core/io/files/readable_text.h"
#include "core/receivers/points/point_list.h"
#include "core/study/point_cases.h"

namespace noonmark {

namespace {

/// Receivers at listed points, in their order, as `settlePoint` (point_cases.h) places them. A point inside
/// a building is left out, with a warning. Error: a value out of range, cancelled(). O(points x parts): in
/// Midtown some 2 ms a point.
Result<PointReceivers> placeListedPoints(const City& city, const std::vector<ListedPoint>& points,
                                         Warnings& warnings, const std::stop_token& stop = {});

Result<PointReceivers> placeListedPoints(const City& city, const std::vector<ListedPoint>& points,
                                         Warnings& warnings, const std::stop_token& stop) {
    constexpr glm::dvec2 half{0.5, 0.5};
    PointReceivers placed;
    for (const ListedPoint& point : points) {
        if (stop.stop_requested()) return cancelled();
        PointQuestion question{.at = point.at, .heightM = point.heightM, .facingDeg = point.facingDeg};
        const auto settled = settlePoint(city, question);
        if (!settled) {
            warnings.push_back({WarningKind::leftOut, settled.error().what, point.id});
            continue;
        }
        placed.points.positions.push_back(settled->point.position);
        placed.points.normals.push_back(settled->point.normal);
        placed.elements.push_back({.id = point.id, .kind = ElementKind::point});
        placed.panes.push_back({-half, half});
    }
    return placed;
}

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

// "way 12" of "way 12 wall 3".
std::vector<std::string> buildingsOf(const std::vector<std::string>& faces) {
    std::vector<std::string> ids;
    for (const std::string& face : faces) ids.push_back(face.substr(0, face.rfind(" wall ")));
    return ids;
}

Result<PlacedElements> placeFacades(const City& city, const Region& region, const ElementSettings& elements,
                                    const std::stop_token& stop) {
    if (elements.proposed && elements.parts.proposed.empty())
        return failure("The city has no proposed buildings", "facades",
                       "Choose a scenario of a project that builds or changes one");
    std::vector<std::string> names = elements.proposed ? elements.parts.proposed : elements.buildings;
    if (names.empty()) names = buildingsOf(elements.faces.faces);
    return chooseBuildings(city, region, names)
        .and_then([&](const std::vector<std::uint32_t>& buildings) {
            return placeOnFacades(city, buildings, elements.facades, stop, elements.parts.storeys);
        })
        .map([&](PointReceivers placed) {
            return PlacedElements{std::move(placed), {}, 0, {}};
        });
}

Result<PlacedElements> placeAllGlazing(const City& city, const Region& region,
                                       const ElementSettings& elements, Progress& progress,
                                       const std::stop_token& stop) {
    GlazingFileSettings file = elements.glazingFile;
    file.place = elements.parts.model;
    auto read = readGlazing(elements.windows, file, city, progress, stop);
    if (!read) return tl::make_unexpected(read.error());
    GlazingPlaced placed = placeGlazing(city, region, read->windows,
                                        {elements.facades.storeyM, elements.glazingFile.aboveGround}, stop);
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
            all.warnings.push_back({WarningKind::leftOut, why, countOf(cells, "cell") + " of the plane"});
    };
    leftOut(plane->insideBuildings, "the plane cuts a building there");
    leftOut(plane->belowGround, "the ground rises above the plane there");
    return all;
}

Result<PlacedElements> placeLines(const City& city, const ElementSettings& elements,
                                  const std::stop_token& stop) {
    if (elements.parts.parcel.empty())
        return failure("The parcel is missing", "lines",
                       "Name a lot of the project, or a file with the parcel as a polygon");
    PlacedElements all;
    all.planeM = findMeanGroundM(city, {elements.parcel, elements.parts.parcel}) + elements.planeHeightM;
    auto placed = placeOnLines(city, elements.parts.parcel, elements.lines, all.planeM, all.warnings, stop);
    if (!placed) return tl::make_unexpected(placed.error());
    all.receivers = *std::move(placed);
    return all;
}

Result<PlacedElements> placeListed(const City& city, const ElementSettings& elements,
                                   const std::stop_token& stop) {
    PlacedElements all;
    auto placed = placeListedPoints(city, elements.points, all.warnings, stop);
    if (!placed) return tl::make_unexpected(placed.error());
    all.receivers = *std::move(placed);
    return all;
}

Result<PlacedElements> placeAll(const City& city, const StudySettings& settings,
                                const ElementSettings& elements, Progress& progress,
                                const std::stop_token& stop) {
    switch (elements.places) {
        case ElementPlaces::facades:
            return placeFacades(city, settings.region, elements, stop);
        case ElementPlaces::windows:
            return placeAllGlazing(city, settings.region, elements, progress, stop);
        case ElementPlaces::plane:
            return placePlane(city, settings, elements.planeHeightM, stop);
        case ElementPlaces::lines:
            return placeLines(city, elements, stop);
        case ElementPlaces::points:
            return placeListed(city, elements, stop);
    }
    return placeListed(city, elements, stop);
}

// Of facades and windows those that the settings take.
void keepChosen(const City& city, const ElementSettings& elements, PlacedElements& placed) {
    const bool onWalls =
        elements.places == ElementPlaces::facades || elements.places == ElementPlaces::windows;
    if (!onWalls || elements.faces.takesAll()) return;
    PlacedElements kept{.planeM = placed.planeM, .warnings = std::move(placed.warnings)};
    const PointReceivers& from = placed.receivers;
    for (std::size_t i = 0; i < from.size(); ++i) {
        if (!takes(elements.faces, elements.parts.facedPlace, city.frame, from.elements[i],
                   from.points.positions[i], from.points.normals[i]))
            continue;
        kept.receivers.points.positions.push_back(from.points.positions[i]);
        kept.receivers.points.normals.push_back(from.points.normals[i]);
        kept.receivers.elements.push_back(from.elements[i]);
        kept.receivers.panes.push_back(from.panes[i]);
        if (!placed.facts.empty()) kept.facts.push_back(std::move(placed.facts[i]));
    }
    placed = std::move(kept);
}

Result<void> checkFaces(const ElementSettings& elements) {
    const FaceChoice& faces = elements.faces;
    if (!(faces.withinM >= 1 && faces.withinM <= FaceChoice::maxWithinM))
        return failure("The distance of the place that is faced is out of range", "facing",
                       "Give 1 to 5000 m");
    if (!faces.place.empty() && elements.parts.facedPlace.empty())
        return failure(fmt::format("There is no place '{}'", faces.place), "facing",
                       "Give the name of a place of the project");
    return {};
}

tl::unexpected<Error> noPoints(const Region& region, const ElementSettings& elements,
                               const Warnings& warnings) {
    const auto groups = groupWarnings(warnings);
    const bool some = !elements.faces.takesAll() && elements.places == ElementPlaces::facades;
    return failure(!groups.empty() ? fmt::format("The study has no points: {}", lineOf(groups.front()))
                   : some ? fmt::format("The study has no points on facades: {}", describe(elements.faces))
                          : fmt::format("The study has no points on {}", nameOf(elements.places)),
                   region.name,
                   some ? "Choose other faces, or a wider range of azimuths"
                        : "Choose a region with buildings, windows on their walls, or a higher plane");
}

}  // namespace

Result<PlacedElements> placeElements(const City& city, const StudySettings& settings,
                                     const ElementSettings& elements, Progress& progress,
                                     const std::stop_token& stop) {
    if (const auto ok = checkFaces(elements); !ok) return tl::make_unexpected(ok.error());
    auto placed = placeAll(city, settings, elements, progress, stop);
    if (!placed) return placed;
    keepChosen(city, elements, *placed);
    if (placed->receivers.size() == 0) return noPoints(settings.region, elements, placed->warnings);
    return placed;
}

}  // namespace noonmark
