#include "scenarios/project/rule_parcels.h"

#include <fmt/format.h>

#include <map>

namespace noonmark {

namespace {

Place asDrawn(const NamedLot& lot) { return {lot.name, PlaceKind::other, {lot.outline}, "lot"}; }

Result<Place> placeNamed(const Rule& rule, const Project& project, const std::string& name) {
    if (rule.receivers.hasLines())
        if (const auto lot = findLot(project, name)) return asDrawn(*lot);
    return findPlace(project, name);
}

Warning describeMove(const NamedLot& lot) {
    return {WarningKind::assumed, "the parcel's line is moved out along the roads that its lot states",
            fmt::format("{}: {}", lot.name, formatText(lot.roads))};
}

Warning describeUnmoved(const NamedLot& lot) {
    return {WarningKind::assumed,
            "none of the parcel's edges lies along the roads that its lot states: its line is not moved",
            fmt::format("{}: {}", lot.name, formatText(lot.roads))};
}

}  // namespace

std::vector<Place> placesUnder(const Rule& rule, const Project& project) {
    if (!rule.receivers.hasLines()) return project.places;
    std::vector<Place> lots;
    for (const NamedLot& lot : project.lots) lots.push_back(asDrawn(lot));
    return lots;
}

Result<std::vector<Place>> findPlacesUnder(const Rule& rule, const Project& project,
                                           const std::vector<std::string>& names) {
    std::vector<Place> places;
    for (const std::string& name : names) {
        auto place = placeNamed(rule, project, name);
        if (!place) return tl::make_unexpected(place.error());
        places.push_back(*std::move(place));
    }
    return places;
}

Result<PlacesToReview> moveLines(const Rule& rule, const Project& project, std::vector<Place> places) {
    PlacesToReview review{std::move(places), {}};
    if (!rule.receivers.roads) return review;
    std::map<std::string, const NamedLot*> lots;
    for (const NamedLot& lot : project.lots) lots.emplace(lot.name, &lot);
    for (Place& place : review.places) {
        const auto found = lots.find(place.name);
        if (found == lots.end() || found->second->roads.empty() || place != asDrawn(*found->second)) continue;
        const NamedLot& lot = *found->second;
        auto polygons = moveLineOut(lot.outline, lot.roads, *rule.receivers.roads);
        if (!polygons) return failure(polygons.error().what, "lot " + lot.name, polygons.error().advice);
        if (*polygons == place.polygons) {
            review.moved.push_back(describeUnmoved(lot));
            continue;
        }
        place.polygons = *std::move(polygons);
        review.moved.push_back(describeMove(lot));
    }
    return review;
}

}  // namespace noonmark
