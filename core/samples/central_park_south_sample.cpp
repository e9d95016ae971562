#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "core/city/meshes/mesh_outline.h"
#include "core/samples/central_park.h"
#include "core/samples/lot_building.h"
#include "core/samples/sample_city.h"

namespace noonmark {

namespace {

constexpr double clearM = 3;          // free ground around a named tower
constexpr std::uint32_t seed = 2017;  // the paper's year; any other number would do

// 60 m in the middle of Midtown, half of that far away; the avenues along the park have higher buildings.
double medianHeight(glm::dvec2 place) {
    const glm::dvec2 d = (place - glm::dvec2{-60, -470}) / 480.0;
    const double share = d.x * d.x + d.y * d.y;
    const StreetBox park = parkBox();
    const bool onPark = place.y > park.south && place.x > park.west - 90 && place.x < park.east + 90;
    return (onPark ? 44.0 : 26.0) + 40 / (1 + share * share);
}

StreetBox widen(const StreetBox& box, double byM) {
    return {box.west - byM, box.south - byM, box.east + byM, box.north + byM};
}

std::vector<StreetBox> clearedBoxes() {
    std::vector<StreetBox> boxes{columbusCircle(), widen(timeWarnerPodium(), clearM)};
    for (const NamedTower& tower : caseStudyTowers()) boxes.push_back(widen(tower.floor, clearM));
    return boxes;
}

BlockSettings quarter(const SkewedAvenue& broadway) {
    BlockSettings settings;
    settings.widths = {.narrowestM = 9, .widestM = 36, .preferWide = 0.5};
    settings.medianHeightM = medianHeight;
    settings.lowestM = 20;
    settings.highestM = 200;
    settings.roundness = 8;
    settings.avenues = {broadway};
    settings.cleared = clearedBoxes();
    return settings;
}

void add(City& city, Building building, std::string id) {
    building.sourceId = std::move(id);
    city.buildings.push_back(std::make_shared<const Building>(std::move(building)));
}

void addBlock(City& city, const BlockSettings& settings, Avenue avenue, int street) {
    SampleRandom random(seed, int(avenue), street);
    for (Building& building : buildOnLots(blockAt(avenue, street), settings, {}, random))
        add(city, std::move(building), fmt::format("lot {}", city.buildings.size() + 1));
}

Building buildingOf(const NamedTower& tower) {
    return {.name = tower.name,
            .status = tower.status,
            .parts = makePrism({cornersOf(tower.floor)}, 0, tower.heightM, {})};
}

Building timeWarnerCenter() {
    Building center{.name = "Time Warner Center", .status = "built"};
    center.parts = makePrism({cornersOf(timeWarnerPodium())}, 0, timeWarnerPodiumM, {});
    for (const NamedTower& tower : timeWarnerTowers())
        for (Part& part : makePrism({cornersOf(tower.floor)}, timeWarnerPodiumM, tower.heightM, {}))
            center.parts.push_back(std::move(part));
    return center;
}

void addMidtown(City& city) {
    const BlockSettings settings = quarter(broadwaySouth());
    for (int street = 49; street < 59; ++street)
        for (int avenue = int(Avenue::tenth); avenue < int(Avenue::third); ++avenue)
            addBlock(city, settings, Avenue(avenue), street);
}

void addParkSides(City& city) {
    const BlockSettings settings = quarter(broadwayNorth());
    for (int street = 59; street < 73; ++street)
        for (const Avenue avenue :
             {Avenue::tenth, Avenue::ninth, Avenue::fifth, Avenue::madison, Avenue::park, Avenue::lexington})
            addBlock(city, settings, avenue, street);
}

// Transforms street axes to another frame's metres.
Footprint groundOf(const StreetPolygon& polygon, const Frame& frame) {
    const Frame own = centralParkFrame();
    Ring ring;
    for (const glm::dvec2 corner : polygon)
        ring.emplace_back(frame.localFromLonLat(own.lonLatFromLocal(StreetAxes{}.localFromStreet(corner))));
    return {std::move(ring), {}};
}

// The lots of a block as addBlock() divides it.
std::vector<Lot> lotsOfBlock(Avenue avenue, int street) {
    SampleRandom random(seed, int(avenue), street);
    const BlockSettings settings = quarter(street < 59 ? broadwaySouth() : broadwayNorth());
    std::vector<Lot> lots = cutIntoLots(blockAt(avenue, street), settings.widths, random);
    for (const SkewedAvenue& broadway : settings.avenues) lots = cutBy(broadway, std::move(lots));
    return lots;
}

std::vector<Lot> emptiedLots(const StreetBox& floor) {
    std::vector<Lot> emptied;
    for (int street = 49; street < 73; ++street)
        for (int avenue = int(Avenue::tenth); avenue < int(Avenue::third); ++avenue) {
            if (!blockAt(Avenue(avenue), street).overlaps(floor)) continue;
            for (const Lot& lot : lotsOfBlock(Avenue(avenue), street))
                if (lot.box.overlaps(widen(floor, clearM))) emptied.push_back(lot);
        }
    return emptied;
}

}  // namespace

City makeCentralParkSouthSample() {
    City city;
    city.frame = centralParkFrame();
    for (const NamedTower& tower : caseStudyTowers()) add(city, buildingOf(tower), tower.name);
    add(city, timeWarnerCenter(), "Time Warner Center");
    addMidtown(city);
    addParkSides(city);
    return city;
}

Region centralParkRegion(const City& city) {
    return {"Central Park, 59th to 72nd Street", {groundOf(cornersOf(parkBox()), city.frame)}};
}

// Joined in street axes, where neighbours share their corners to the last bit.
std::vector<CaseStudyLot> listCaseStudyLots(const City& city) {
    std::vector<CaseStudyLot> lots;
    for (const NamedTower& tower : caseStudyTowers()) {
        std::vector<Footprint> pieces;
        for (const Lot& lot : emptiedLots(tower.floor))
            pieces.push_back({{lot.ground.begin(), lot.ground.end()}, {}});
        for (const Footprint& joined : computeUnion(pieces))
            lots.push_back({tower.name, groundOf({joined.outer.begin(), joined.outer.end()}, city.frame)});
    }
    return lots;
}

}  // namespace noonmark
