#include "core/samples/central_park.h"

#include <fmt/format.h>
#include <algorithm>
#include <array>

#include "core/samples/sample_city.h"

namespace noonmark {

namespace {

struct Sides {
    double west, east;
};
// In the order of the enumeration. Blocks are 800 or 920 feet long, Madison and Lexington Avenues lie
// between; the park's corner is 14 m into Fifth Avenue.
constexpr std::array<Sides, 10> avenues{{
    {-1422.5, -1392},
    {-1148, -1117.5},
    {-873.5, -843},
    {-599, -568.5},
    {-324.5, -294},
    {-14, 16.5},
    {144.5, 168.5},
    {296, 339},
    {464, 487},
    {615, 645.5},
}};

constexpr double streetDistanceM = 80.47;  // twenty blocks to the mile
constexpr double middleOf59th = -17;

const Sides& sidesOf(Avenue avenue) { return avenues[std::size_t(avenue)]; }
double findMiddle(int street) { return middleOf59th + (street - 59) * streetDistanceM; }
double halfWidthOf(int street) { return street == 57 || street == 59 || street == 72 ? 15.2 : 9.1; }

const glm::dvec2 circleMiddle{-858, middleOf59th};

}  // namespace

Frame centralParkFrame() { return Frame({-73.97300, 40.76432}); }

double westSideOf(Avenue avenue) { return sidesOf(avenue).west; }
double eastSideOf(Avenue avenue) { return sidesOf(avenue).east; }
double southSideOf(int street) { return findMiddle(street) - halfWidthOf(street); }
double northSideOf(int street) { return findMiddle(street) + halfWidthOf(street); }

StreetBox blockAt(Avenue avenue, int street) {
    const Avenue next = Avenue(int(avenue) + 1);
    return {eastSideOf(avenue), northSideOf(street), westSideOf(next), southSideOf(street + 1)};
}

StreetBox parkBox() {
    return {eastSideOf(Avenue::eighth), northSideOf(59), westSideOf(Avenue::fifth), southSideOf(72)};
}

SkewedAvenue broadwaySouth() { return {.through = circleMiddle, .eastPerNorth = -0.243, .widthM = 28}; }
SkewedAvenue broadwayNorth() { return {.through = circleMiddle, .eastPerNorth = -0.525, .widthM = 36}; }

StreetBox columbusCircle() {
    constexpr double radiusM = 45;
    return {circleMiddle.x - radiusM, circleMiddle.y - radiusM, circleMiddle.x + radiusM,
            circleMiddle.y + radiusM};
}

namespace {

constexpr const char* built = "built";
constexpr const char* toBeBuilt = "to be built";

/// Size across and along the avenues, metres.
struct Floor {
    double width, depth;
};

// As near to `middle` as the block allows.
StreetBox floorOn(const StreetBox& block, glm::dvec2 middle, Floor floor) {
    const double x = std::clamp(middle.x, block.west + floor.width / 2, block.east - floor.width / 2);
    const double y = std::clamp(middle.y, block.south + floor.depth / 2, block.north - floor.depth / 2);
    return {x - floor.width / 2, y - floor.depth / 2, x + floor.width / 2, y + floor.depth / 2};
}

NamedTower tower(const char* name, const char* status, LonLat place, double heightM, Floor floor,
                 const StreetBox& block) {
    const glm::dvec2 middle = StreetAxes{}.streetFromLocal(centralParkFrame().localFromLonLat(place));
    return {name, status, place, heightM, floorOn(block, middle, floor)};
}

}  // namespace

std::vector<NamedTower> caseStudyTowers() {
    return {
        tower("One57", built, {-73.9791, 40.7655}, 306.1, {24, 42}, blockAt(Avenue::seventh, 57)),
        tower("432 Park Avenue", built, {-73.9719, 40.7616}, 425.7, {28.5, 28.5},
              blockAt(Avenue::madison, 56)),
        tower("111 West 57th Street", toBeBuilt, {-73.9776, 40.7648}, 435.3, {18, 24},
              blockAt(Avenue::seventh, 57)),
        tower("Central Park Tower", toBeBuilt, {-73.9810, 40.7663}, 472.4, {30, 32},
              blockAt(Avenue::eighth, 57)),
        tower("220 Central Park South", toBeBuilt, {-73.9803, 40.7672}, 289.6, {26, 28},
              blockAt(Avenue::eighth, 58)),
        tower("53 West 53rd Street", toBeBuilt, {-73.9785, 40.7616}, 320.1, {26, 36},
              blockAt(Avenue::sixth, 53)),
        tower("520 Park Avenue", toBeBuilt, {-73.9705, 40.7646}, 237.7, {22, 20},
              blockAt(Avenue::madison, 60)),
    };
}

StreetBox timeWarnerPodium() { return {-1010, -88, -915, 47}; }

std::vector<NamedTower> timeWarnerTowers() {
    constexpr double heightM = 228.6;
    const LonLat place{-73.9830, 40.7685};
    return {
        {"South tower", built, place, heightM, {-975, -80, -945, -33}},
        {"North tower", built, place, heightM, {-975, -8, -945, 39}},
    };
}

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
