#include "core/measures/shadow_outlines.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/core/engines/terrain_scenes.h"

namespace noonmark {
namespace {

using namespace tests;

const OutlineSettings around{{{-200, -200}, {200, 200}}, 1};

TEST(ShadowFan, IsTheProposalsOwnShadowAtEachStepAndTheirUnion) {
    // A box of 20 x 20 m, 40 m high. Suns at 45 deg in the east, south and west: shadows of 20 x 40 m to the
    // west, north and east, which do not overlap.
    const City proposal = cityOf({{{0, 0, 0}, {20, 20, 40}}});
    const auto steps = oneDay({{90, 45}, {180, 45}, {270, 45}}).steps;
    NoProgress progress;
    const ShadowFan fan = outlineShadowFan(proposal, steps, around, progress, {}).value();
    ASSERT_EQ(fan.ofStep.size(), 3U);
    for (const auto& outline : fan.ofStep) EXPECT_NEAR(area(outline), 800, 0.02);
    EXPECT_NEAR(area(fan.all), 2400, 0.1);
    EXPECT_EQ(fan.cellM, 0);
}

TEST(ShadowFan, OverlappingMomentsCountOnceInTheUnion) {
    const City proposal = cityOf({{{0, 0, 0}, {20, 20, 40}}});
    const auto steps = oneDay({{180, 45}, {180, 60}}).steps;  // 40 m and 23.09 m long
    NoProgress progress;
    const ShadowFan fan = outlineShadowFan(proposal, steps, around, progress, {}).value();
    EXPECT_NEAR(area(fan.ofStep[1]), 20 * 20 * 2 / std::sqrt(3.0), 0.02);
    EXPECT_NEAR(area(fan.all), 800, 0.02);
}

TEST(ShadowFan, OnTerrainLeavesOutTheTerrainsOwnShadow) {
    // A cliff of 60 m at y = -20, and a box north of it within the cliff's shadow, which is 60 m long.
    City proposal = groundOf(61, [](glm::dvec2 place) { return place.y < -20 ? 60.0 : 0.0; });
    proposal.buildings.push_back(buildingOf({{0, 0, 0}, {20, 10, 15}}));
    const auto steps = oneDay({{180, 45}}).steps;
    NoProgress progress;
    const ShadowFan fan = outlineShadowFan(proposal, steps, around, progress, {}).value();
    EXPECT_EQ(fan.cellM, 1);
    EXPECT_TRUE(fan.all.empty());
}

TEST(ShadowFan, TheBoxHoldsAllShadows) {
    // Shadows of 40 m to the west and to the north, of 300 m to the east cut to 100 m.
    const City proposal = cityOf({{{0, 0, 0}, {20, 20, 40}}});
    const auto steps = oneDay({{90, 45}, {180, 45}, {270, 7.594643}}).steps;
    const Box2 box = boundShadows(proposal, steps, 100);
    EXPECT_NEAR(box.low.x, -40, 0.01);
    EXPECT_NEAR(box.low.y, 0, 0.01);
    EXPECT_NEAR(box.high.x, 120, 0.01);
    EXPECT_NEAR(box.high.y, 60, 0.01);
    EXPECT_TRUE(boundShadows({}, steps, 100).empty());
}

}  // namespace
}  // namespace noonmark
