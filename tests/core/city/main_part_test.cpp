#include "core/city/city_position.h"

#include <gtest/gtest.h>

namespace noonmark {
namespace {

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
