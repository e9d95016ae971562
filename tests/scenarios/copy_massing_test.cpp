#include "scenarios/massing/copy_massing.h"

#include <gtest/gtest.h>

namespace noonmark {
namespace {

Footprint rectangle(float west, float south, float width, float depth) {
    return {{{west, south}, {west + width, south}, {west + width, south + depth}, {west, south + depth}}, {}};
}

const Footprint wide = rectangle(0, 0, 60, 40);  // 2400 m2

TEST(CopyMassing, KeepsStoreysAndAreaOnAnotherLot) {
    const MassingSettings settings{.storeys = 12, .plate = {.shareOfLot = 0.25}};  // 600 m2
    const auto copy = copyMassing(wide, settings, rectangle(500, 100, 30, 50));    // 1500 m2
    ASSERT_TRUE(copy);
    EXPECT_EQ(copy->settings.plate.areaM2, 600);
    EXPECT_FALSE(copy->plateReduced || copy->turnDropped || copy->setbacksDropped);
    const auto made = makeMassing(rectangle(500, 100, 30, 50), copy->settings);
    ASSERT_TRUE(made);
    EXPECT_NEAR(made->figures.grossFloorM2, 12 * 600, 2);
    EXPECT_EQ(made->figures.storeys, 12);
}

TEST(CopyMassing, ReducesAPlateToTheLotAndToThePodium) {
    const Footprint small = rectangle(0, 0, 20, 20);  // 400 m2
    const auto copy = copyMassing(wide, {.storeys = 5, .plate = {.areaM2 = 600}}, small);
    ASSERT_TRUE(copy);
    EXPECT_TRUE(copy->plateReduced);
    EXPECT_EQ(copy->settings.plate.areaM2, 400);
    const MassingSettings onPodium{
        .storeys = 9, .plate = {.areaM2 = 300}, .podium = Podium{2, {.areaM2 = 250}}};
    const auto podium = copyMassing(wide, onPodium, small);
    ASSERT_TRUE(podium);
    EXPECT_EQ(podium->settings.plate.areaM2, 250) << "not beyond its podium";
}

TEST(CopyMassing, AWholeLotStaysAWholeLot) {
    const auto copy = copyMassing(rectangle(0, 0, 20, 20), {.storeys = 5}, wide);
    ASSERT_TRUE(copy);
    EXPECT_EQ(copy->settings.plate, (PlateSize{.shareOfLot = 1}));
    EXPECT_FALSE(copy->plateReduced);
}

TEST(CopyMassing, DropsWhatIsNotPossibleThere) {
    // 16 m of setbacks leave nothing of a plate 20 m wide; turned by 45 degrees, it leaves its lot.
    MassingSettings settings{.storeys = 20, .plate = {.areaM2 = 400}, .setbacks = {{20, 4}, {40, 12}}};
    settings.clockwiseDeg = 45;
    const auto copy = copyMassing(wide, settings, rectangle(0, 0, 20, 20));
    ASSERT_TRUE(copy);
    EXPECT_TRUE(copy->turnDropped);
    EXPECT_EQ(copy->setbacksDropped, 1);
    EXPECT_FALSE(copyMassing(wide, settings, rectangle(0, 0, 1, 2))) << "no lot to build on";
}

TEST(CopyMassing, DropsATwistThatWouldLeaveTheLot) {
    const MassingSettings settings{
        .storeys = 20, .plate = {.areaM2 = 380}, .walls = {.taper = 0.1, .twistDeg = 45}};
    const auto copy = copyMassing(wide, settings, rectangle(0, 0, 20, 20));
    ASSERT_TRUE(copy);
    EXPECT_TRUE(copy->twistDropped);
    EXPECT_EQ(copy->settings.walls, (WallShape{.taper = 0.1}));
    EXPECT_FALSE(copyMassing(wide, settings, rectangle(0, 0, 60, 60))->twistDropped);
}

}  // namespace
}  // namespace noonmark
