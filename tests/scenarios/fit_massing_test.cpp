#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "scenarios/massing/fit_floor_area.h"
#include "tests/scenarios/small_town.h"

namespace noonmark::tests {
namespace {

using testing::HasSubstr;

const Footprint lot40x20 = box(0, 0, 40, 20);  // 800 m2

double floorAreaOf(const MassingSettings& settings) {
    return makeMassing(lot40x20, settings).value().figures.grossFloorM2;
}

TEST(FitFloorArea, TakesTheMostStoreysThatStayWithinIt) {
    const MassingSettings settings{.storeyHeightM = 4, .heightM = 30};
    const auto within = fitFloorArea(lot40x20, settings, 8100, FloorAreaBy::storeys).value();
    EXPECT_EQ(within.storeys, 10);
    EXPECT_EQ(within.heightM, 0);
    const FloorAreaTarget ratio{.floorAreaRatio = 10};
    EXPECT_EQ(fitFloorArea(lot40x20, settings, *ratio.areaOn(lot40x20), ratio.by).value().storeys, 10);
    EXPECT_FALSE(FloorAreaTarget{}.areaOn(lot40x20));
}

TEST(FitFloorArea, SizesThePlateOfThisManyStoreys) {
    const MassingSettings settings{
        .storeys = 20, .podium = Podium{.storeys = 2}, .setbacks = {{.aboveM = 50, .insetM = 2}}};
    const auto fitted = fitFloorArea(lot40x20, settings, 8000, FloorAreaBy::plate).value();
    EXPECT_EQ(fitted.storeys, 20);
    EXPECT_NEAR(floorAreaOf(fitted), 8000, 8);
    const MassingSettings whole{.storeys = 10};
    EXPECT_NEAR(*fitFloorArea(lot40x20, whole, 8000, FloorAreaBy::plate).value().plate.areaM2, 800, 0.8);
}

TEST(FitFloorArea, SaysWhatCanBeReached) {
    const MassingSettings low{.storeys = 3};
    EXPECT_THAT(fitFloorArea(lot40x20, low, 8000, FloorAreaBy::plate).error().text(),
                HasSubstr("Give more storeys or a larger lot"));
    const MassingSettings podium{.storeys = 10, .podium = Podium{.storeys = 3}};
    EXPECT_THAT(fitFloorArea(lot40x20, podium, 2000, FloorAreaBy::storeys).error().text(),
                HasSubstr("4 storeys have 3200 m2 already"));
    EXPECT_THAT(fitFloorArea(lot40x20, low, 1e6, FloorAreaBy::storeys).error().text(),
                HasSubstr("500 storeys have 400000 m2"));
    EXPECT_FALSE(fitFloorArea(lot40x20, low, 0, FloorAreaBy::storeys));
}

// Half of the lot is a plate of 32.36 x 12.36 m. Turned by 14 degrees it is 19.8 m deep, by 15 degrees 20.3
// m.
TEST(NearestFit, IsTheLargestTurnThatStaysOnTheLot) {
    const MassingSettings possible{.storeys = 10, .plate = {.shareOfLot = 0.5}};
    MassingSettings wanted = possible;
    wanted.clockwiseDeg = 90;
    const auto fit = findNearestFit(lot40x20, possible, wanted);
    ASSERT_TRUE(fit);
    EXPECT_EQ(fit->number, MassingNumber::turn);
    EXPECT_DOUBLE_EQ(fit->settings.clockwiseDeg, 14);
    EXPECT_EQ(fit->settings.storeys, 10);
    EXPECT_EQ(fit->settings.plate.shareOfLot, 0.5);
}

TEST(NearestFit, KeepsHeightsPodiumsAndSetbacksInOrder) {
    const MassingSettings possible{
        .storeyHeightM = 4, .storeys = 10, .podium = Podium{.storeys = 5}, .setbacks = {{30, 2}}};
    MassingSettings low = possible;
    low.storeys = 3;
    EXPECT_EQ(findNearestFit(lot40x20, possible, low)->settings.storeys, 8);  // the setback begins at 30 m
    MassingSettings podium = possible;
    podium.podium->storeys = 12;
    const auto fit = findNearestFit(lot40x20, possible, podium);
    EXPECT_EQ(fit->number, MassingNumber::podiumStoreys);
    EXPECT_EQ(fit->settings.podium->storeys, 7);
    MassingSettings deep = possible;
    deep.setbacks[0].insetM = 30;
    EXPECT_NEAR(findNearestFit(lot40x20, possible, deep)->settings.setbacks[0].insetM, 9.9, 0.11);
    MassingSettings large = possible;
    large.podium.reset();
    MassingSettings larger = large;
    larger.plate.areaM2 = 900;
    EXPECT_DOUBLE_EQ(*findNearestFit(lot40x20, large, larger)->settings.plate.areaM2, 800);
}

TEST(NearestFit, IsNotKnownWhereSeveralNumbersDiffer) {
    const MassingSettings possible{.storeys = 10, .plate = {.shareOfLot = 0.5}};
    MassingSettings wanted = possible;
    wanted.clockwiseDeg = 90;
    wanted.plate.shareOfLot = 0.9;
    EXPECT_FALSE(findNearestFit(lot40x20, possible, wanted));
    wanted.podium = Podium{};
    EXPECT_FALSE(findNearestFit(lot40x20, possible, wanted));
}

}  // namespace
}  // namespace noonmark::tests
