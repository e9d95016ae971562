#include "core/lab/accrual/shadow_accrual_map.h"

#include <gtest/gtest.h>
#include <tbb/task_arena.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "core/lab/graph/graph_engine.h"
#include "tests/core/engines/scenes.h"

namespace noonmark {
namespace {

using namespace tests;

SunInterval hour(double fromAzimuth, double toAzimuth, double fromAltitude, double toAltitude,
                 int steps = 60) {
    return {glm::normalize(glm::dvec3(towardsSun(fromAzimuth, fromAltitude))),
            glm::normalize(glm::dvec3(towardsSun(toAzimuth, toAltitude))), steps};
}

ShadowField accrued(const City& city, const Receivers& receivers, const SunSteps& sun,
                    const AccrualSettings& settings = {}) {
    NoProgress progress;
    return GraphEngine(ShadowAccrualMap::make(settings).value(), {.merge = false})
        .accumulate(city, receivers, sun, progress, {})
        .value();
}

/// A day on which the sun follows one great circle during each hour, as the accrual maps assume.
SunSteps greatCircles(int hours, double noonAltitudeDeg) {
    SunSteps sun;
    sun.days.push_back({.first = 0, .count = std::uint32_t(hours * 60)});
    const std::vector<Sun> ends = arc(hours + 1, noonAltitudeDeg);
    for (int h = 0; h < hours; ++h) {
        const auto [a, b] = std::pair(ends[std::size_t(h)], ends[std::size_t(h) + 1]);
        const SunInterval interval = hour(a.azimuthDeg, b.azimuthDeg, a.altitudeDeg, b.altitudeDeg);
        for (int k = 0; k < 60; ++k)
            sun.steps.push_back({.direction = glm::vec3(interval.at(k)), .slot = h * 60 + k});
    }
    return sun;
}

// Share of cell-steps that differ from the rays, in percent, with both kinds of difference added.
double meanErrorPercent(const ShadowField& field, const ShadowField& truth, const Receivers& receivers,
                        std::size_t steps) {
    double sum = 0;
    for (const std::uint32_t cell : receivers.cells)
        sum += std::abs(double(field.grossMin[cell]) - double(truth.grossMin[cell]));
    return 100 * sum / (double(receivers.cells.size()) * double(steps));
}

TEST(ShadowAccrualMap, AgreesWithTheRaysWhereTheSunMovesStraight) {
    for (std::uint32_t seed = 1; seed <= 3; ++seed) {
        const City city = cityOf(randomBoxes(seed, 10));
        const Receivers receivers = receiversOver(city, -10, -10, 210, 210);
        const SunSteps sun = greatCircles(6, 50);
        const ShadowField truth = traced(city, receivers, sun);
        for (const CasterSide side : {CasterSide::towardsSun, CasterSide::awayFromSun})
            EXPECT_LT(meanErrorPercent(accrued(city, receivers, sun, {.side = side}), truth, receivers, 360),
                      0.005)
                << seed;
        // Half a texel: the border of every shadow is off by up to this much.
        EXPECT_LT(
            meanErrorPercent(accrued(city, receivers, sun, {.texelsOnCells = false}), truth, receivers, 360),
            0.6)
            << seed;
    }
}

TEST(ShadowAccrualMap, ErrorShrinksWithTheTexels) {
    const City city = cityOf(randomBoxes(5, 10));
    const Receivers receivers = receiversOver(city, -10, -10, 210, 210);
    const SunSteps sun = greatCircles(2, 50);
    const ShadowField truth = traced(city, receivers, sun);
    double before = 100;
    for (const int size : {64, 128, 256, 512, 1024}) {
        const double error = meanErrorPercent(
            accrued(city, receivers, sun, {.mapSize = size, .texelsOnCells = false}), truth, receivers, 120);
        EXPECT_LT(error, before * 0.75) << size;
        before = error;
    }
}

TEST(ShadowAccrualMap, GroundBelowSomethingThatHangsIsShaded) {
    const City city = cityOf({{{10, 10, 20}, {30, 30, 25}}});
    const Receivers receivers = receiversOver(city, 0, 0, 60, 60);
    const SunSteps sun = oneDay({{180, 89}, {180, 60}});
    const ShadowField truth = traced(city, receivers, sun);
    for (const CasterSide side : {CasterSide::towardsSun, CasterSide::awayFromSun})
        EXPECT_LT(meanErrorPercent(accrued(city, receivers, sun, {.side = side}), truth, receivers, 2), 0.1);
}

TEST(ShadowAccrualMap, DoesNotDependOnTheNumberOfThreads) {
    const City city = cityOf(randomBoxes(6, 8));
    const Receivers receivers = receiversOver(city, -10, -10, 170, 170);
    const SunSteps sun = oneDay(arc(130, 40));
    std::vector<float> one, many;
    tbb::task_arena(1).execute([&] { one = accrued(city, receivers, sun).grossMin; });
    tbb::task_arena(2).execute([&] { many = accrued(city, receivers, sun).grossMin; });
    for (const std::uint32_t cell : receivers.cells) ASSERT_EQ(one[cell], many[cell]);
}

TEST(ShadowAccrualMap, Stops) {
    const City city = cityOf(randomBoxes(6, 4));
    const Receivers receivers = receiversOver(city, -10, -10, 90, 90);
    const auto scene =
        ShadowAccrualMap::make({}).value()->prepare(city, receivers, oneDay(arc(60, 40)), {}).value();
    std::vector<ShadowMask> masks(receivers.cells.size());
    std::stop_source stop;
    stop.request_stop();
    EXPECT_TRUE(isCancelled(scene->shade(hour(120, 135, 30, 40), masks, stop.get_token()).error()));
}

TEST(ShadowAccrualMap, RefusesTerrain) {
    City city = cityOf({{{0, 0, 0}, {1, 1, 1}}});
    const Receivers receivers = receiversOver(city, -2, -2, 2, 2);
    city.terrain = std::make_shared<const Terrain>(Terrain{{-5, -5, 5, 2, 2}, {0, 0, 0, 1}});
    const GraphEngine engine(ShadowAccrualMap::make({}).value(), {});
    NoProgress progress;
    const auto field = engine.accumulate(city, receivers, oneDay({{90, 20}}), progress, {});
    ASSERT_FALSE(field);
    EXPECT_EQ(field.error().advice, "Choose the horizon sweep or the ray reference");
}

TEST(ShadowAccrualMap, SaysWhatItLeftOut) {
    std::vector<Box3> boxes = randomBoxes(9, 4);
    boxes.push_back({{5000, 0, 0}, {5010, 10, 10}});
    const City city = cityOf(boxes);
    const ShadowField field = accrued(city, receiversOver(city, 20, 20, 60, 60), oneDay(arc(60, 50)));
    EXPECT_GE(field.cost.skipped.at("buildings whose shadow cannot reach a receiver"), 1U);
    EXPECT_GT(field.cost.skipped.at("faces on the lit side of solids, or on the ground"), 0U);
    EXPECT_GT(field.cost.skipped.at("faces whose shadow meets no receiver"), 0U);
}

TEST(ShadowAccrualMap, RefusesSettingsOutOfRangeWithTheRange) {
    const auto advice = [](const AccrualSettings& settings) {
        return ShadowAccrualMap::make(settings).error().advice;
    };
    EXPECT_EQ(advice({.mapSize = 0}), "Give 16 to 8192 texels");
    EXPECT_EQ(advice({.mapSize = 8193}), "Give 16 to 8192 texels");
    EXPECT_EQ(advice({.biasM = -1}), "Give 0 to 10 m");
    EXPECT_EQ(advice({.biasM = std::nanf("")}), "Give 0 to 10 m");
    EXPECT_EQ(advice({.slopeBias = 17}), "Give 0 to 16 texels");
    const City city = cityOf({{{0, 0, 0}, {1, 1, 1}}});
    const Receivers receivers = receiversOver(city, -2, -2, 2, 2);
    auto scene = ShadowAccrualMap::make({}).value()->prepare(city, receivers, oneDay({{90, 20}}), {}).value();
    std::vector<ShadowMask> masks(receivers.cells.size());
    EXPECT_EQ(scene->shade(hour(90, 100, 20, 20, 65), masks, {}).error().advice, "Give 1 to 64 steps");
}

}  // namespace
}  // namespace noonmark
