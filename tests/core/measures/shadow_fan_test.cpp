#include "core/measures/outlines/shadow_fan.h"

#include <gtest/gtest.h>

#include "tests/core/engines/terrain_scenes.h"

namespace noonmark {
namespace {

using namespace tests;

const OutlineSettings around{{{-200, -200}, {200, 200}}, 1};

TEST(ShadowFan, IsTheProposalsOwnShadowAtEachStepAndTheirUnion) {
    // A box of 20 x 20 m, 40 m high, in the shadow of a large neighbour. Suns at 45 deg in the east, south
    // and west: shadows of 20 x 40 m to the west, north and east, which do not overlap.
    City before;
    before.buildings.push_back(buildingOf({{-100, -40, 0}, {100, -20, 150}}));
    City after = before;
    after.buildings.push_back(buildingOf({{0, 0, 0}, {20, 20, 40}}));
    const auto steps = oneDay({{90, 45}, {180, 45}, {270, 45}}).steps;
    NoProgress progress;
    const ShadowFan fan = outlineShadowFan(before, after, steps, around, progress, {}).value();
    ASSERT_EQ(fan.ofStep.size(), 3U);
    for (const auto& outline : fan.ofStep) EXPECT_NEAR(area(outline), 800, 0.02);
    EXPECT_NEAR(area(fan.all), 2400, 0.1);
    EXPECT_EQ(fan.cellM, 0);
}

TEST(ShadowFan, OverlappingMomentsCountOnceInTheUnion) {
    const City before, after = cityOf({{{0, 0, 0}, {20, 20, 40}}});
    const auto steps = oneDay({{180, 45}, {180, 60}}).steps;  // 40 m and 23.09 m long
    NoProgress progress;
    const ShadowFan fan = outlineShadowFan(before, after, steps, around, progress, {}).value();
    EXPECT_NEAR(area(fan.ofStep[1]), 20 * 40 / std::sqrt(3.0), 0.02);
    EXPECT_NEAR(area(fan.all), 800, 0.02);
}

TEST(ShadowFan, OnTerrainLeavesOutTheTerrainsOwnShadow) {
    // A cliff of 60 m at y = -20, and a box north of it within the cliff's shadow, which is 60 m long.
    City before = groundOf(61, [](glm::dvec2 place) { return place.y < -20 ? 60.0 : 0.0; }), after = before;
    after.buildings.push_back(buildingOf({{0, 0, 0}, {20, 10, 15}}));
    const auto steps = oneDay({{180, 45}}).steps;
    NoProgress progress;
    const ShadowFan fan = outlineShadowFan(before, after, steps, around, progress, {}).value();
    EXPECT_EQ(fan.cellM, 1);
    EXPECT_TRUE(fan.all.empty());
}

TEST(ShadowFan, OfEqualCitiesIsEmpty) {
    const City city = cityOf({{{0, 0, 0}, {20, 20, 40}}});
    const auto steps = oneDay({{180, 45}}).steps;
    NoProgress progress;
    EXPECT_TRUE(outlineShadowFan(city, city, steps, around, progress, {}).value().all.empty());
    EXPECT_TRUE(boundChangedShadows(city, city, steps, 1000).empty());
}

TEST(ShadowFan, TheBoxHoldsAllShadowsOfWhatChanged) {
    // Shadows of 40 m to the west and to the north, of 300 m to the east cut to 100 m.
    const City before, after = cityOf({{{0, 0, 0}, {20, 20, 40}}});
    const auto steps = oneDay({{90, 45}, {180, 45}, {270, 7.594643}}).steps;
    const Box2 box = boundChangedShadows(before, after, steps, 100);
    EXPECT_NEAR(box.low.x, -40, 0.01);
    EXPECT_NEAR(box.low.y, 0, 0.01);
    EXPECT_NEAR(box.high.x, 120, 0.01);
    EXPECT_NEAR(box.high.y, 60, 0.01);
}

}  // namespace
}  // namespace noonmark
