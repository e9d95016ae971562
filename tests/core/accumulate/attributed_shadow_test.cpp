#include "core/accumulate/attributed_shadow.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/accumulate/graph_accumulator.h"
#include "core/accumulate/inverse_accrual_map.h"
#include "core/accumulate/ray_interval.h"
#include "core/accumulate/ray_scene.h"
#include "core/accumulate/shadow_accrual_map.h"
#include "tests/core/accumulate/scenes.h"

namespace noonmark {
namespace {

using namespace tests;

AttributedShadow attributed(const City& city, const Receivers& receivers, const SunSteps& sun) {
    NoProgress progress;
    const auto engine = InverseAccrualMap::make({}).value();
    return attributedShadow(*engine, {.merge = false}, city, receivers, sun, progress, {}).value();
}

// The first building on each ray.
std::vector<double> firstOnRays(const City& city, const Receivers& receivers, const SunSteps& sun) {
    const RayScene scene = RayScene::over(city).value();
    std::vector<double> minM2(city.buildings.size());
    for (const SunStep& step : sun.steps)
        for (const std::uint32_t cell : receivers.cells)
            if (const auto hit = scene.firstHit(rayOrigin(receivers.position(cell)), step.direction))
                minM2[*hit->building] += sun.stepMinutes * receivers.grid.cellAreaM2();
    return minM2;
}

TEST(AttributedShadow, whereTwoShadesTheNearerHasIt) {
    const City city = cityOf({{{0, 0, 0}, {20, 60, 30}}, {{60, 0, 0}, {70, 60, 45}}});
    const Receivers receivers = receiversOver(city, -60, -20, 110, 80);
    const std::vector<Sun> day = arc(720, 50);
    const SunSteps sun = oneDay({day.begin() + 200, day.begin() + 320});
    const AttributedShadow shadow = attributed(city, receivers, sun);
    const std::vector<double> truth = firstOnRays(city, receivers, sun);
    for (std::size_t building = 0; building < 2; ++building)
        EXPECT_NEAR(shadow.minM2[building], truth[building], 0.04 * truth[building]) << building;
}

TEST(AttributedShadow, eachBuildingHasWhatRaysGiveIt) {
    for (std::uint32_t seed = 1; seed <= 2; ++seed) {
        const City city = cityOf(randomBoxes(seed, 6));
        const Receivers receivers = receiversOver(city, -10, -10, 130, 130);
        const SunSteps sun = oneDay(arc(360, 55));
        const AttributedShadow shadow = attributed(city, receivers, sun);
        const std::vector<double> truth = firstOnRays(city, receivers, sun);
        double apart = 0, all = 0;
        for (std::size_t i = 0; i < truth.size(); ++i) {
            apart += std::abs(shadow.minM2[i] - truth[i]);
            all += truth[i];
        }
        EXPECT_LT(apart, 0.05 * all) << seed;
    }
}

// Each step of each cell belongs to one building.
void expectSharesOfAll(const SunSteps& sun) {
    const City city = cityOf(randomBoxes(3, 6));
    const Receivers receivers = receiversOver(city, -10, -10, 130, 130);
    NoProgress progress;
    const auto engine = InverseAccrualMap::make({}).value();
    const auto shadow = attributedShadow(*engine, {}, city, receivers, sun, progress, {}).value();
    const ShadowField field =
        GraphAccumulator(engine, {}).accumulate(city, receivers, sun, progress, {}).value();
    double gross = 0;
    for (const std::uint32_t cell : receivers.cells) gross += double(field.grossMin[cell]) * field.days;
    EXPECT_GT(gross, 0);
    EXPECT_NEAR(shadow.totalMinM2, gross, 1e-3);
}

TEST(AttributedShadow, sharesAddUpToTheGrossShadow) {
    SunSteps sun = oneDay(arc(200, 50));
    addDay(sun, arc(200, 50));  // the same day again: its edges count twice
    expectSharesOfAll(sun);
}

// Below InverseAccrualSettings::lowestSunDeg rays take over, and give each step to one building too.
TEST(AttributedShadow, sharesAddUpToTheGrossShadowAtDawn) {
    std::vector<Sun> dawn;
    for (int minute = 0; minute < 60; ++minute) dawn.push_back({90 + minute * 0.2, 0.3 + minute * 0.25});
    expectSharesOfAll(oneDay(dawn));
}

TEST(AttributedShadow, anEngineThatDoesNotKnowSaysSo) {
    const City city = cityOf({{{0, 0, 0}, {20, 60, 30}}});
    NoProgress progress;
    EXPECT_FALSE(attributedShadow(*ShadowAccrualMap::make({}).value(), {}, city,
                                  receiversOver(city, -20, -20, 40, 80), oneDay(arc(60, 50)), progress, {}));
}

TEST(RayIntervals, areTheRayReferenceWhereTheSunIsStraight) {
    const City city = cityOf(randomBoxes(5, 5));
    const Receivers receivers = receiversOver(city, -10, -10, 110, 110);
    const SunSteps sun = oneDay({{120, 40}, {121, 40}, {180, 60}, {181, 60}});
    NoProgress progress;
    // Intervals of two steps have no steps between their ends.
    const ShadowField graph =
        GraphAccumulator(std::make_shared<RayIntervals>(), {.intervalMinutes = 2, .merge = false})
            .accumulate(city, receivers, sun, progress, {})
            .value();
    const ShadowField rays = traced(city, receivers, sun);
    for (const std::uint32_t cell : receivers.cells) {
        EXPECT_EQ(graph.grossMin[cell], rays.grossMin[cell]) << cell;
        EXPECT_EQ(graph.continuousMin[cell], rays.continuousMin[cell]) << cell;
    }
}

}  // namespace
}  // namespace noonmark
