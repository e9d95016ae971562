#include "scenarios/project/rule_parcels.h"

#include <fmt/format.h>

namespace noonmark {

namespace {

Place asDrawn(const NamedLot& lot) { return {lot.name, PlaceKind::other, {lot.outline}, "lot"}; }

Result<Place> parcelOf(const Rule& rule, const NamedLot& lot) {
    Place parcel = asDrawn(lot);
    if (!rule.receivers.roads || lot.roads.empty()) return parcel;
    return moveLineOut(lot.outline, lot.roads, *rule.receivers.roads)
        .map([&](std::vector<Footprint> polygons) {
            parcel.polygons = std::move(polygons);
            parcel.source = fmt::format("lot, its line moved out along roads: {}", formatText(lot.roads));
            return parcel;
        });
}

Result<Place> placeNamed(const Rule& rule, const Project& project, const std::string& name) {
    if (rule.receivers.hasLines())
        if (const auto lot = findLot(project, name)) return parcelOf(rule, *lot);
    return findPlace(project, name);
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

}  // namespace noonmark
