#include "core/city/main_bounds.h"

#include <gtest/gtest.h>

namespace noonmark {
namespace {

std::shared_ptr<const Building> squareAt(float x, float y) {
    Building building;
    building.parts.push_back(
        {.footprint = {{{x, y}, {x + 10, y}, {x + 10, y + 10}, {x, y + 10}}, {}}, .topM = 10});
    return std::make_shared<const Building>(std::move(building));
}

City village() {
    City city;
    for (int i = 0; i < 100; ++i)
        city.buildings.push_back(squareAt(float(20 * (i % 10)), float(20 * (i / 10))));
    return city;
}

TEST(MainBounds, ADistantBuildingDoesNotCount) {
    City city = village();
    const Box2 all = bounds(city);
    city.buildings.push_back(squareAt(40000, 0));
    city.buildings.push_back(squareAt(0, -9000));
    EXPECT_EQ(mainBounds(city), all);
}

TEST(MainBounds, AreAllBoundsWhereNothingIsDistant) {
    const City city = village();
    EXPECT_EQ(mainBounds(city), bounds(city));
    City one;
    one.buildings.push_back(squareAt(5, 5));
    EXPECT_EQ(mainBounds(one), bounds(one));
    EXPECT_TRUE(mainBounds(City()).empty());
}

TEST(MainBounds, TwoVillagesAreBothCounted) {
    City city = village();
    for (int i = 0; i < 50; ++i) city.buildings.push_back(squareAt(2000 + float(20 * (i % 10)), 0));
    EXPECT_EQ(mainBounds(city), bounds(city));
}

}  // namespace
}  // namespace noonmark
