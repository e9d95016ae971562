#include "core/engines/common/open_below.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "core/engines/horizon/horizon_sweep.h"
#include "core/engines/points/point_horizons.h"
#include "core/sun/sun_steps.h"
#include "tests/core/engines/scenes.h"

namespace noonmark {
namespace {

using namespace tests;

/// A block of 30 x 20 m up to 40 m. A second part, from there up to 60 m, reaches `overM` farther west.
City blockWithStrip(float overM) {
    Building building;
    building.parts.push_back({.footprint = {rectangle(0, 0, 30, 20), {}}, .topM = 40});
    building.parts.push_back({.footprint = {rectangle(-overM, 0, 30, 20), {}}, .bottomM = 40, .topM = 60});
    City city;
    city.buildings.push_back(std::make_shared<const Building>(std::move(building)));
    return city;
}

std::vector<OpenBelow> openOf(const City& city) {
    const std::vector<std::uint32_t> all{0};
    return findOpenBelow(city, all);
}

TEST(OpenBelow, IsWhereNothingCarriesAPart) {
    EXPECT_TRUE(openOf(blockWithStrip(0)).empty());
    const std::vector<OpenBelow> open = openOf(blockWithStrip(1.5F));
    ASSERT_EQ(open.size(), 1U);
    EXPECT_NEAR(open[0].box.low.x, -1.5, 0.01);
    EXPECT_NEAR(open[0].box.high.x, 0, 0.01);
    EXPECT_NEAR(open[0].box.high.y, 20, 0.01);
    EXPECT_EQ(open[0].bottomM, 40);
    EXPECT_EQ(open[0].partTopM, 60);
}

TEST(OpenBelow, IsSeenWithinAnArcUpToTheTopOfItsPart) {
    const OpenBelow open{{rectangle(-1, -1, 1, 1), {}}, {{-1, -1}, {1, 1}}, 40, 60};
    const SeenOpenBelow far = seeFrom(open, {{-100, 0, 0}, {-100, 0, 0}});
    EXPECT_NEAR(far.azimuthRad, std::numbers::pi / 2, 1e-6);
    EXPECT_GE(std::tan(far.halfRad), 1 / 99.0);
    EXPECT_LT(far.halfRad, 0.02);
    EXPECT_GE(far.topTan, 60 / 99.0);
    EXPECT_LT(far.topTan, 0.62);
    EXPECT_EQ(seeFrom(open, {{-100, 0, 41}, {-100, 0, 41}}).topTan, 0) << "above the underside";
    EXPECT_TRUE(isIn(open, {0, 0, 39}));
    EXPECT_FALSE(isIn(open, {0, 0, 41}));
    EXPECT_FALSE(isIn(open, {2, 0, 39}));
    EXPECT_GE(seeFrom(open, {{-3, 0, 0}, {3, 0, 0}}).halfRad, std::numbers::pi) << "eyes all around";
}

// The strip is 1.5 m of 31.5 m: no overhang. By horizons alone the sun is lost below it for up to 20 minutes.
TEST(LongestRunErrors, AreTwoStepsAtMostBelowAPartThatCountsAsSolid) {
    const City city = blockWithStrip(1.5F);
    const Receivers receivers = receiversOver(city, -8.3F, -10.3F, 4.7F, 30.7F);
    const SunSteps sun = days(40.7, 20, 1);
    NoProgress progress;
    const ShadowField truth = traced(city, receivers, sun),
                      field = HorizonSweep().accumulate(city, receivers, sun, progress, {}).value();
    double worst = 0, grossOff = 0;
    for (const std::uint32_t cell : receivers.cells) {
        worst = std::max(worst, std::abs(double(field.continuousMin[cell] - truth.continuousMin[cell])));
        grossOff = std::max(grossOff, std::abs(double(field.grossMin[cell] - truth.grossMin[cell])));
    }
    EXPECT_LE(worst, 2.01);
    EXPECT_GT(grossOff, 2.01) << "gross shadow counts it as solid";
}

TEST(SurfaceHorizons, LongestTimesAreRightBelowAPartThatCountsAsSolid) {
    const City city = blockWithStrip(1.5F);
    SunSteps sun = days(40.7, 20, 1);
    for (SunDay& day : sun.days) day.date = std::chrono::year(2026) / 1 / 1;
    SurfacePoints points;
    for (float y = -14; y < 40; y += 2) {
        points.positions.emplace_back(-6, y, 1.5F);
        points.normals.emplace_back(0, 1, 0);
        points.positions.emplace_back(-0.7F, y, 5);
        points.normals.emplace_back(0, -1, 0);
    }
    NoProgress progress;
    const PointMonths swept = sweepPoints(city, points, sun, progress, {}, {.runs = true}).value(),
                      truth = tracePoints(city, points, sun, progress, {}).value();
    double grossOff = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        EXPECT_NEAR(swept.longestShadowMin[i], truth.longestShadowMin[i], 2.01) << i;
        EXPECT_NEAR(swept.longestSunMin[i], truth.longestSunMin[i], 2.01) << i;
        grossOff = std::max(grossOff, std::abs(swept.sunlitOf(i) - truth.sunlitOf(i)));
    }
    EXPECT_GT(grossOff, 100);
}

}  // namespace
}  // namespace noonmark
