#include <gtest/gtest.h>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "core/city/city_position.h"
#include "core/geo/frame.h"
#include "tests/core/study/geocentric_reference_erfa.h"

namespace noonmark {

namespace {

using namespace tests;

constexpr double toDegrees = 180 / std::numbers::pi;

City cityAt(LonLat origin, bool terrain) {
    City city{.frame = Frame(origin)};
    if (terrain) city.terrain = std::make_shared<const Terrain>(Terrain{{0, 0, 10, 1, 1}, {0.0F}});
    return city;
}

// A point near the observer, offset by (east, north, up), transformed as readers transform geometry.
glm::dvec3 placedAt(const City& city, LonLat observer, glm::dvec3 eastNorthUp) {
    const Geodetic at = displaced({observer.lonDeg, observer.latDeg}, eastNorthUp.x, eastNorthUp.y);
    const glm::dvec2 local = city.frame.localFromLonLat({at.lonDeg, at.latDeg});
    return {local, eastNorthUp.z - (city.terrain ? earthDropM(local) : 0)};
}

TEST(CityObserver, AtTheOriginTheFrameIsTheObserversOwn) {
    for (const bool terrain : {false, true}) {
        const Observer observer = placeObserver(cityAt({10, 62}, terrain), {0, 0});
        for (int column = 0; column < 3; ++column)
            for (int row = 0; row < 3; ++row)
                EXPECT_NEAR(observer.frameFromPlace[column][row], column == row ? 1 : 0, 1e-12);
    }
}

TEST(CityObserver, DirectionsRunAsTheGeometryDoes) {
    for (const LonLat origin : {LonLat{10, 62}, LonLat{151, -33.9}, LonLat{179.9, -17.5}, LonLat{-60, 0.1}})
        for (const bool terrain : {false, true})
            for (const glm::dvec2 local : {glm::dvec2(27e3, 4e3), {-30e3, 30e3}, {0, -45e3}}) {
                const City city = cityAt(origin, terrain);
                const Observer observer = placeObserver(city, local);
                const glm::dvec3 eastNorthUp(6, -3, 2);
                const glm::dvec3 moved = placedAt(city, observer.place, eastNorthUp) -
                                         placedAt(city, observer.place, -eastNorthUp);
                const glm::dvec3 turned = observer.frameFromPlace * eastNorthUp;
                EXPECT_LT(glm::length(moved / 2.0 - turned), 2e-5) << origin.latDeg << ' ' << local.x;
            }
}

// d_lon sin(lat), and 0.87 of the angle at the earth's centre: 27.5 km east at 62 deg north.
TEST(CityObserver, TurnsByTheConvergenceAndTheSlopeOfTheDrop) {
    const Observer observer = placeObserver(cityAt({10, 62}, true), {27.5e3, 0});
    const double convergence = (observer.place.lonDeg - 10) * std::sin(62 / toDegrees);
    ASSERT_NEAR(convergence, 0.464, 0.001);
    const glm::dvec3 north = observer.frameFromPlace[1], east = observer.frameFromPlace[0];
    EXPECT_NEAR(std::atan2(-north.x, north.y) * toDegrees, convergence, 1e-4);
    EXPECT_NEAR(std::atan2(-east.z, east.x) * toDegrees, 0.87 * 27.5e3 / 6371009 * toDegrees, 1e-4);
}

std::shared_ptr<const Building> squareAt(float x, float y, float sideM = 10) {
    Building building;
    building.parts.push_back(
        {.footprint = {{{x, y}, {x + sideM, y}, {x + sideM, y + sideM}, {x, y + sideM}}, {}}, .topM = 10});
    return std::make_shared<const Building>(std::move(building));
}

City squareVillage() {
    City city;
    for (int i = 0; i < 100; ++i)
        city.buildings.push_back(squareAt(float(20 * (i % 10)), float(20 * (i / 10))));
    return city;
}

TEST(MainPart, DistantBuildingsAreLeftAsideAndCounted) {
    City city = squareVillage();
    const Box2 all = bounds(city);
    city.buildings.push_back(squareAt(40000, 0));
    city.buildings.push_back(squareAt(0, -9000));
    city.buildings.push_back(squareAt(900, 0));
    const MainPart part = findMainPart(city);
    EXPECT_EQ(part.box, all);
    EXPECT_EQ(part.farBuildings, 3U);
}

TEST(MainPart, IsTheWholeCityWhereNothingIsDistant) {
    const City city = squareVillage();
    EXPECT_EQ(findMainPart(city).box, bounds(city));
    EXPECT_EQ(findMainPart(city).farBuildings, 0U);
    City one;
    one.buildings.push_back(squareAt(5, 5));
    EXPECT_EQ(findMainPart(one).box, bounds(one));
    EXPECT_TRUE(findMainPart(City()).box.empty());
}

TEST(MainPart, TwoVillagesAreBothCounted) {
    City city = squareVillage();
    for (int i = 0; i < 50; ++i) city.buildings.push_back(squareAt(2000 + float(20 * (i % 10)), 0));
    EXPECT_EQ(findMainPart(city).box, bounds(city));
    EXPECT_EQ(findMainPart(city).farBuildings, 0U);
}

TEST(MainPart, AHouseJustOutsideBelongsToIt) {
    City city = squareVillage();
    city.buildings.push_back(squareAt(380, 0));
    EXPECT_EQ(findMainPart(city).box, bounds(city));
}

// Footprint area counts, not the number of buildings: 30 huts in a lake do not outweigh a village.
TEST(MainPart, ManyHutsFarOutAreStillFar) {
    City city = squareVillage();
    const Box2 all = bounds(city);
    for (int i = 0; i < 30; ++i) city.buildings.push_back(squareAt(5000 + float(10 * i), 0, 2));
    EXPECT_EQ(findMainPart(city).box, all);
    EXPECT_EQ(findMainPart(city).farBuildings, 30U);
}

TEST(DensestBox, LiesWhereMostGroundIsBuiltOn) {
    City city = squareVillage();  // 190 m wide
    for (int i = 0; i < 10; ++i) city.buildings.push_back(squareAt(300 + 100 * float(i), 0));
    const Box2 within = bounds(city);
    const Box2 box = findDensestBox(city, within, {200, 200});
    EXPECT_EQ(box.low, within.low);
    EXPECT_FLOAT_EQ(box.high.x - box.low.x, 200);
    EXPECT_FLOAT_EQ(box.high.y - box.low.y, 190) << "no larger than what it lies in";
}

TEST(DensestBox, LiesInTheMiddleOfAnEvenCity) {
    const City city = squareVillage();
    const Box2 within = bounds(city), box = findDensestBox(city, within, {100, 100});
    EXPECT_EQ(box.low + box.high, within.low + within.high);
}

}  // namespace

}  // namespace noonmark
