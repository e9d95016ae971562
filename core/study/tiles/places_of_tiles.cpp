#include "core/study/tiles/places_of_tiles.h"

#include <fmt/format.h>

#include "core/receivers/place_names.h"

namespace noonmark {

namespace {

glm::dvec2 middleOf(const Box2& box) { return (glm::dvec2(box.low) + glm::dvec2(box.high)) / 2.0; }

std::string kindsOf(const PlaceSettings& reading) {
    std::string text;
    for (const PlaceKind kind : reading.kinds) text += fmt::format("{},", nameOf(kind));
    return text;
}

}  // namespace

std::string PlacesRequest::key() const {
    return fmt::format("{};{};{};{};{};{};{};{};{};{};{}", placesHash, kindsOf(reading), reading.streets,
                       reading.sidewalkM, reading.unnamed, reading.minAreaM2, reading.farAwayM,
                       reading.nameField, nameOf(reading.kind), reading.layer, reading.crs.value_or("")) +
           (reading.wholeStreets ? "" : ";cut streets");
}

Result<std::vector<Place>> readPlaces(const PlacesRequest& request, const Frame& frame, Progress& progress,
                                      const std::stop_token& stop) {
    if (!request.own.empty()) return request.own;
    return readPlaces(request.places, request.reading, frame, progress, stop).map([](PlacesRead read) {
        return std::move(read.places);
    });
}

PlacesOfTiles::PlacesOfTiles(std::vector<Place> places, const TilePlan& plan)
    : plan_(plan), byTile_(plan.count()) {
    for (Place& place : places)
        if (const auto tile = plan.tileAt(middleOf(bounds(place))))
            byTile_[*tile].push_back(std::move(place));
}

const std::vector<Place>& PlacesOfTiles::in(const Grid& tile) const {
    return of(plan_.tileAt({(tile.westM + tile.eastM()) / 2, (tile.southM + tile.northM()) / 2}).value());
}

Box2 PlacesOfTiles::boxOf(std::size_t tile) const {
    Box2 box;
    for (const Place& place : of(tile)) box.add(bounds(place));
    return box;
}

}  // namespace noonmark
