#include <gmock/gmock.h>

#include <algorithm>
#include <glm/geometric.hpp>
#include <random>

#include "core/city/meshes/mesh_outline.h"
#include "core/samples/sample_city.h"
#include "tests/core/samples/sample_checks.h"

namespace noonmark {
namespace {

using namespace tests;

const Building* named(const City& city, const std::string& name) {
    for (const auto& building : city.buildings)
        if (building->name == name) return building.get();
    return nullptr;
}

glm::dvec2 findMiddle(const Box2& box) { return (glm::dvec2(box.low) + glm::dvec2(box.high)) / 2.0; }

struct Known {
    const char* name;
    const char* status;
    double heightM;
    double footprintM2;
    LonLat place;
};

// Published figures, repeated here independently.
const std::vector<Known> known{
    {"432 Park Avenue", "built", 425.7, 28.5 * 28.5, {-73.9719, 40.7616}},
    {"One57", "built", 306, 1000, {-73.9791, 40.7655}},
    {"111 West 57th Street", "to be built", 435, 18 * 24, {-73.9776, 40.7648}},
    {"Central Park Tower", "to be built", 472, 960, {-73.9810, 40.7663}},
    {"220 Central Park South", "to be built", 290, 730, {-73.9803, 40.7672}},
    {"53 West 53rd Street", "to be built", 320, 940, {-73.9785, 40.7616}},
    {"520 Park Avenue", "to be built", 238, 440, {-73.9705, 40.7646}},
    {"Time Warner Center", "built", 229, 12825, {-73.9830, 40.7685}},
};

TEST(CentralParkSouth, NamedTowersHaveTheirHeightSizeAndPlace) {
    const City city = makeCentralParkSouthSample();
    for (const Known& tower : known) {
        SCOPED_TRACE(tower.name);
        const Building* building = named(city, tower.name);
        ASSERT_NE(building, nullptr);
        EXPECT_EQ(building->status, tower.status);
        EXPECT_NEAR(topM(*building), tower.heightM, 0.6);
        EXPECT_NEAR(area(building->parts[0].footprint), tower.footprintM2, 0.07 * tower.footprintM2);
        EXPECT_LT(glm::distance(findMiddle(bounds(*building)), city.frame.localFromLonLat(tower.place)), 30);
    }
    EXPECT_EQ(named(city, "Time Warner Center")->parts.size(), 3U);
}

TEST(CentralParkSouth, OtherBuildingsHaveNoNameAndPlausibleHeights) {
    const City city = makeCentralParkSouthSample();
    EXPECT_GT(city.buildings.size(), 2500U);
    EXPECT_LT(city.buildings.size(), 4000U);
    std::size_t nameless = 0;
    for (const auto& building : city.buildings) {
        if (!building->name.empty()) continue;
        ++nameless;
        EXPECT_GE(topM(*building), 20);
        EXPECT_LE(topM(*building), 200);
        EXPECT_EQ(building->status, "built");
    }
    EXPECT_EQ(nameless + known.size(), city.buildings.size());
}

TEST(CentralParkSouth, EveryBuildingIsAValidSolidAndStandsApart) {
    const City city = makeCentralParkSouthSample();
    for (const auto& building : city.buildings) EXPECT_EQ(faultOf(*building), "") << building->sourceId;
    EXPECT_EQ(cellsInTwoBuildings(city, bounds(city), 0.5), 0U);
}

TEST(CentralParkSouth, TheParkIsAParkOfItsSize) {
    const City city = makeCentralParkSouthSample();
    const Region park = centralParkRegion(city);
    ASSERT_EQ(park.polygons.size(), 1U);
    EXPECT_EQ(tests::faultOf(park.polygons[0]), "");
    EXPECT_NEAR(area(park.polygons[0]), 829 * 1016, 2000);
    for (const LonLat corner : {LonLat{-73.98180, 40.76810}, LonLat{-73.97300, 40.76432}}) {
        double nearest = 1e9;
        for (const glm::vec2 point : park.polygons[0].outer)
            nearest = std::min(nearest, glm::distance(glm::dvec2(point), city.frame.localFromLonLat(corner)));
        EXPECT_LT(nearest, 20);
    }
    std::mt19937 random(1);
    const Box2 box = bounds(park);
    for (int i = 0; i < 300; ++i) {
        const glm::dvec2 share{double(random() % 1000) / 1000, double(random() % 1000) / 1000};
        const glm::dvec2 point = glm::dvec2(box.low) + share * glm::dvec2(box.high - box.low);
        EXPECT_FALSE(contains(park.polygons[0], point) && anyContains(city, point));
    }
}

TEST(CentralParkSouth, TheParkFollowsTheFrame) {
    City moved;
    moved.frame = Frame({-73.99, 40.75});
    const City city = makeCentralParkSouthSample();
    const Ring here = centralParkRegion(city).polygons[0].outer;
    const Ring there = centralParkRegion(moved).polygons[0].outer;
    for (std::size_t i = 0; i < here.size(); ++i) {
        const LonLat place = city.frame.lonLatFromLocal(glm::dvec2(here[i]));
        EXPECT_LT(glm::distance(moved.frame.localFromLonLat(place), glm::dvec2(there[i])), 0.01);
    }
}

TEST(CentralParkSouth, IsAlwaysTheSame) {
    EXPECT_EQ(fingerprintOf(makeCentralParkSouthSample()), fingerprintOf(makeCentralParkSouthSample()));
}

TEST(CentralParkSouth, EveryCaseStudyTowerHasALotOfItsOwn) {
    const City city = makeCentralParkSouthSample();
    const std::vector<CaseStudyLot> lots = listCaseStudyLots(city);
    ASSERT_EQ(lots.size(), 7U);
    for (std::size_t i = 0; i < lots.size(); ++i) {
        const Footprint& tower = city.buildings[i]->parts[0].footprint;
        EXPECT_EQ(lots[i].tower, city.buildings[i]->name);
        EXPECT_LT(computeAreaOutside(tower, {lots[i].ground}), 0.1) << lots[i].tower;
        EXPECT_GT(area(lots[i].ground), 1.2 * area(tower)) << lots[i].tower;
        for (std::size_t b = 0; b < city.buildings.size(); ++b) {
            if (b == i) continue;
            for (const Part& part : city.buildings[b]->parts)
                EXPECT_LT(area(part.footprint) - computeAreaOutside(part.footprint, {lots[i].ground}), 0.5)
                    << lots[i].tower << ", " << city.buildings[b]->sourceId;
        }
    }
}

TEST(CentralParkSouth, HasItsParkAndStreetsBetweenJunctions) {
    const Frame frame = makeCentralParkSouthSample().frame;
    const std::vector<Place> places = listCentralParkPlaces(frame);
    EXPECT_EQ(places.front().name, "Central Park");
    // From Eighth to Fifth Avenue 829 m, from 59th to 72nd Street 1,015.7 m.
    EXPECT_NEAR(area(places.front().polygons.front()), 829 * 1015.7, 2000);
    const auto street =
        std::ranges::find(places, "West 58th Street, Seventh Avenue to Sixth Avenue", &Place::name);
    ASSERT_NE(street, places.end());
    EXPECT_NEAR(area(street->polygons.front()), (568.5 - 324.5) * 18.2, 5) << "244 m long and 18.2 m wide";
    EXPECT_EQ(std::ranges::count(places, PlaceKind::street, &Place::kind), std::ptrdiff_t(places.size()) - 1);
    for (const Place& place : places)
        EXPECT_FALSE(place.name.starts_with("Seventh Avenue, 60th")) << "it ends at the park";
}

TEST(CentralParkSouth, NoBuildingStandsInTheMiddleOfAStreet) {
    const City city = makeCentralParkSouthSample();
    for (const Place& place : listCentralParkPlaces(city.frame)) {
        const glm::dvec2 middle = findMiddle(bounds(place.polygons.front()));
        for (const auto& building : city.buildings)
            for (const Part& part : building->parts)
                EXPECT_FALSE(contains(part.footprint, middle)) << place.name << ": " << building->sourceId;
    }
}

TEST(CentralParkSouth, ItsMapHasParkStreetsAndBroadway) {
    const MapContext context = makeCentralParkContext(makeCentralParkSouthSample().frame);
    ASSERT_EQ(context.areas.size(), 1U);
    EXPECT_EQ(context.areas[0].kind, ContextKind::park);
    EXPECT_EQ(std::ranges::count(context.lines, std::string("Broadway"), &ContextLine::name), 2);
    EXPECT_EQ(std::ranges::count(context.lines, std::string("Fifth Avenue"), &ContextLine::name), 1);
}

}  // namespace
}  // namespace noonmark
