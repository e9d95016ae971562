#include "app/input/find_element_parts.h"

#include <algorithm>
#include <set>

#include "core/io/read_region.h"
#include "core/receivers/place_names.h"
#include "scenarios/massing/tower_design.h"

namespace noonmark {

namespace {

Result<void> findFacedPlace(ElementSettings& elements, const std::vector<Place>& places) {
    if (elements.faces.place.empty()) return {};
    const auto place = findPlace(places, elements.faces.place);
    if (!place) return tl::make_unexpected(place.error());
    elements.parts.facedPlace = place->polygons;
    return {};
}

bool measuresLines(const ElementSettings& elements) {
    return elements.places == ElementPlaces::lines && !elements.parcel.empty();
}

Result<void> readParcel(ElementSettings& elements, const Frame& frame) {
    const auto region = readRegion(elements.parcel, frame);
    if (!region) return tl::make_unexpected(region.error());
    elements.parts.parcel = region->polygons;
    return {};
}

// A name of the project comes before a file of that name.
Result<void> findParcel(ElementSettings& elements, const Project& project, const Frame& frame) {
    if (!measuresLines(elements)) return {};
    std::vector<Footprint>& parcel = elements.parts.parcel;
    if (const auto lot = findLot(project, elements.parcel))
        parcel = {lot->outline};
    else if (const auto region = findRegion(project, elements.parcel))
        parcel = region->polygons;
    else if (const auto place = findPlace(project, elements.parcel))
        parcel = place->polygons;
    else if (const auto read = readParcel(elements, frame); !read)
        return tl::make_unexpected(Error{lot.error().what + ", and no file of that name can be read",
                                         elements.parcel, lot.error().advice});
    return {};
}

void findProposed(ElementSettings& elements, const City& existing, const City& city) {
    std::set<const Building*> before;
    for (const auto& building : existing.buildings) before.insert(building.get());
    for (const auto& building : city.buildings)
        if (!before.contains(building.get())) elements.parts.proposed.push_back(building->sourceId);
}

/// Storeys as they were designed. Where scenarios have different towers of one id, none is known.
OwnStoreys findDesignedStoreys(const std::vector<Scenario>& scenarios) {
    OwnStoreys storeys;
    std::set<std::string> unclear;
    for (const Scenario& scenario : scenarios)
        for (const auto& [id, tower] : findProposedTowers(scenario.edits)) {
            if (tower.storeyHeightM <= 0) continue;
            const auto [at, isNew] = storeys.emplace(id, tower.storeyHeightM);
            if (!isNew && at->second != tower.storeyHeightM) unclear.insert(id);
        }
    for (const std::string& id : unclear) storeys.erase(id);
    return storeys;
}

}  // namespace

Result<ElementSettings> findElementParts(ElementSettings elements, const Project& project, const City& city) {
    elements.parts = {};
    elements.parts.storeys = findDesignedStoreys(project.scenarios);
    if (elements.proposed) findProposed(elements, *project.city, city);
    return findFacedPlace(elements, project.places)
        .and_then([&] { return findParcel(elements, project, city.frame); })
        .map([&] { return std::move(elements); });
}

Result<ElementSettings> findElementParts(ElementSettings elements, const std::vector<Place>& places,
                                         const City& city) {
    elements.parts = {};
    if (elements.proposed)
        return failure("Only a project has proposed buildings", "--facades-of proposed",
                       "Give one project file, NAME.noonmark.gpkg");
    return findFacedPlace(elements, places)
        .and_then([&] { return measuresLines(elements) ? readParcel(elements, city.frame) : Result<void>(); })
        .map([&] { return std::move(elements); });
}

}  // namespace noonmark
