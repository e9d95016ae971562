#include <fmt/format.h>

#include <array>

#include "core/samples/central_park_streets.h"
#include "core/samples/central_park_towers.h"
#include "core/samples/sample_city.h"

namespace noonmark {

namespace {

constexpr int firstStreet = 49, lastStreet = 72;
constexpr std::array avenueNames{"Tenth Avenue",     "Ninth Avenue", "Eighth Avenue",  "Seventh Avenue",
                                 "Sixth Avenue",     "Fifth Avenue", "Madison Avenue", "Park Avenue",
                                 "Lexington Avenue", "Third Avenue"};
constexpr const char* parkName = "Central Park";

std::string ordinal(int street) {
    const int last = street % 10;
    return fmt::format("{}{}", street, last == 1 ? "st" : last == 2 ? "nd" : last == 3 ? "rd" : "th");
}

std::string nameOf(Avenue avenue) { return avenueNames[std::size_t(avenue)]; }

/// A piece of a street between two junctions.
struct StreetPiece {
    std::string street;
    std::string between;
    StreetBox box;
};

bool holds(const StreetBox& box, glm::dvec2 at) {
    return at.x > box.west && at.x < box.east && at.y > box.south && at.y < box.north;
}

// Streets end at the park, and 59th Street at the podium over it.
bool isStreet(const StreetBox& box) {
    return !holds(parkBox(), box.middle()) && !holds(timeWarnerPodium(), box.middle());
}

void addPiece(std::vector<StreetPiece>& pieces, StreetPiece piece) {
    if (isStreet(piece.box)) pieces.push_back(std::move(piece));
}

void addStreetPieces(std::vector<StreetPiece>& pieces, int street) {
    for (int i = int(Avenue::tenth); i < int(Avenue::third); ++i) {
        const Avenue west = Avenue(i), east = Avenue(i + 1);
        const char* const side = west < Avenue::fifth ? "West" : "East";
        addPiece(pieces, {fmt::format("{} {} Street", side, ordinal(street)),
                          fmt::format("{} to {}", nameOf(west), nameOf(east)),
                          {eastSideOf(west), southSideOf(street), westSideOf(east), northSideOf(street)}});
    }
}

void addAvenuePieces(std::vector<StreetPiece>& pieces, int street) {
    for (int i = int(Avenue::tenth); i <= int(Avenue::third); ++i) {
        const Avenue avenue = Avenue(i);
        addPiece(pieces,
                 {nameOf(avenue),
                  fmt::format("{} to {} Street", ordinal(street), ordinal(street + 1)),
                  {westSideOf(avenue), northSideOf(street), eastSideOf(avenue), southSideOf(street + 1)}});
    }
}

std::vector<StreetPiece> listPieces() {
    std::vector<StreetPiece> pieces;
    for (int street = firstStreet; street <= lastStreet; ++street) addStreetPieces(pieces, street);
    for (int street = firstStreet; street < lastStreet; ++street) addAvenuePieces(pieces, street);
    return pieces;
}

glm::dvec2 localOf(glm::dvec2 street, const Frame& frame) {
    return frame.localFromLonLat(centralParkFrame().lonLatFromLocal(StreetAxes{}.localFromStreet(street)));
}

Footprint footprintOf(const StreetBox& box, const Frame& frame) {
    Ring ring;
    for (const glm::dvec2 corner : cornersOf(box)) ring.emplace_back(localOf(corner, frame));
    return {std::move(ring), {}};
}

ContextLine lineOf(std::string name, double widthM, glm::dvec2 from, glm::dvec2 to, const Frame& frame) {
    return {ContextKind::street,
            std::move(name),
            float(widthM),
            {glm::vec2(localOf(from, frame)), glm::vec2(localOf(to, frame))}};
}

// Whole streets; those that end at the park have two lines.
void addStreetLines(MapContext& context, int street, const Frame& frame) {
    const double y = (southSideOf(street) + northSideOf(street)) / 2;
    const double west = westSideOf(Avenue::tenth), east = eastSideOf(Avenue::third);
    const double widthM = northSideOf(street) - southSideOf(street);
    const bool endsAtPark = street > 59 && street < 72;
    const double untilWest = endsAtPark ? parkBox().west : westSideOf(Avenue::fifth);
    const double fromEast = endsAtPark ? parkBox().east : westSideOf(Avenue::fifth);
    context.lines.push_back(
        lineOf(fmt::format("West {} Street", ordinal(street)), widthM, {west, y}, {untilWest, y}, frame));
    context.lines.push_back(
        lineOf(fmt::format("East {} Street", ordinal(street)), widthM, {fromEast, y}, {east, y}, frame));
}

void addAvenueLine(MapContext& context, Avenue avenue, const Frame& frame) {
    const double x = (westSideOf(avenue) + eastSideOf(avenue)) / 2;
    const bool endsAtPark = avenue == Avenue::sixth || avenue == Avenue::seventh;
    const double north = endsAtPark ? southSideOf(59) : northSideOf(lastStreet);
    context.lines.push_back(lineOf(nameOf(avenue), eastSideOf(avenue) - westSideOf(avenue),
                                   {x, southSideOf(firstStreet)}, {x, north}, frame));
}

void addBroadway(MapContext& context, const SkewedAvenue& broadway, double toY, const Frame& frame) {
    const glm::dvec2 from = broadway.through;
    const glm::dvec2 to{from.x + broadway.eastPerNorth * (toY - from.y), toY};
    context.lines.push_back(lineOf("Broadway", broadway.widthM, from, to, frame));
}

}  // namespace

MapContext makeCentralParkContext(const Frame& frame) {
    MapContext context;
    context.areas.push_back({ContextKind::park, parkName, {footprintOf(parkBox(), frame)}});
    for (int street = firstStreet; street <= lastStreet; ++street) addStreetLines(context, street, frame);
    for (int avenue = int(Avenue::tenth); avenue <= int(Avenue::third); ++avenue)
        addAvenueLine(context, Avenue(avenue), frame);
    addBroadway(context, broadwaySouth(), southSideOf(firstStreet), frame);
    addBroadway(context, broadwayNorth(), northSideOf(lastStreet), frame);
    return context;
}

std::vector<Place> listCentralParkPlaces(const Frame& frame) {
    std::vector<Place> places{{parkName, PlaceKind::park, {footprintOf(parkBox(), frame)}, "sample park"}};
    for (const StreetPiece& piece : listPieces()) {
        const std::string name = piece.street + ", " + piece.between;
        places.push_back({name, PlaceKind::street, {footprintOf(piece.box, frame)}, "sample " + name});
    }
    return places;
}

}  // namespace noonmark
