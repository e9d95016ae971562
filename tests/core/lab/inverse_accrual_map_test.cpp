#include "core/lab/inverse/inverse_accrual_map.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/engines/ray/ray_scene.h"
#include "core/lab/graph/graph_engine.h"
#include "core/measures/statistics.h"
#include "core/samples/sample_city.h"
#include "tests/core/engines/scenes.h"

namespace noonmark {
namespace {

using namespace tests;

ShadowField accrued(const City& city, const Receivers& receivers, const SunSteps& sun,
                    const InverseAccrualSettings& settings) {
    NoProgress progress;
    const auto engine = InverseAccrualMap::make(settings).value();
    return GraphEngine(engine, {.merge = false}).accumulate(city, receivers, sun, progress, {}).value();
}

double areaErrorPercent(const ShadowField& field, const ShadowField& truth) {
    const auto a = computeStatistics(field), b = computeStatistics(truth);
    return 100 * std::abs(a.shadowAreaM2 - b.shadowAreaM2) / b.receiverAreaM2;
}

TEST(FirstOccluders, ListsEachBuildingOnceNearestFirst) {
    // Three slabs in a row, the first two with a shared wall.
    const City city =
        cityOf({{{0, 0, 0}, {10, 40, 100}}, {{10, 0, 0}, {20, 40, 100}}, {{40, 0, 0}, {50, 40, 100}}});
    const RayScene scene = RayScene::over(city).value();
    const std::vector<glm::vec3> origins{{-20, 20, 0}, {30, 20, 0}, {60, 20, 0}, {-0.5F, 20, 0}};
    std::vector<Occluder> found(origins.size() * 3);
    scene.firstOccluders(origins, towardsSun(90, 20), 1, 3, found);
    const double toMetres = 1 / std::cos(20 * std::numbers::pi / 180);
    EXPECT_NEAR(found[0].distanceM, 20 * toMetres, 1e-3);
    EXPECT_EQ(found[0].building, 0U);
    EXPECT_NEAR(found[1].distanceM, 30 * toMetres, 1e-3);
    EXPECT_EQ(found[1].building, 1U);
    EXPECT_NEAR(found[2].distanceM, 60 * toMetres, 1e-3);
    EXPECT_EQ(found[2].building, 2U);
    EXPECT_NEAR(found[3].distanceM, 10 * toMetres, 1e-3);
    EXPECT_EQ(found[3].building, 2U);
    EXPECT_EQ(found[4].distanceM, 0);
    EXPECT_EQ(found[6].distanceM, 0);
    EXPECT_NEAR(found[9].distanceM, 10.5 * toMetres,
                1e-3);  // the wall half a metre away is ignored, the exit of the building is not
    EXPECT_EQ(found[9].building, 0U);
}

TEST(FirstOccluders, WritesNothingForLanesWithoutAReceiver) {
    const City city = cityOf({{{0, 0, 0}, {10, 40, 100}}});
    const RayScene scene = RayScene::over(city).value();
    for (std::size_t count = 1; count < 16; ++count) {
        const std::vector<glm::vec3> origins(count, glm::vec3(-20, 20, 0));
        std::vector<Occluder> found(16, Occluder{-1, 77});
        scene.firstOccluders(origins, towardsSun(90, 20), 1, 1, std::span(found).first(count));
        for (std::size_t i = 0; i < found.size(); ++i)
            EXPECT_EQ(found[i].building, i < count ? 0U : 77U) << i << " of " << count;
    }
}

TEST(FirstOccluders, FewerLevelsGiveTheNearest) {
    const City city = cityOf(randomBoxes(5, 8));
    const RayScene scene = RayScene::over(city).value();
    std::mt19937 random(2);
    std::uniform_real_distribution<float> at(-20, 180);
    for (int round = 0; round < 200; ++round) {
        std::vector<glm::vec3> origins(16);
        for (auto& origin : origins) origin = {at(random), at(random), 0};
        const glm::vec3 sun = towardsSun(round * 3.7, 5 + round % 60);
        std::vector<Occluder> three(std::size_t{16} * 3), one(16), eight(std::size_t{16} * 8);
        scene.firstOccluders(origins, sun, 0.001F, 3, three);
        scene.firstOccluders(origins, sun, 0.001F, 1, one);
        scene.firstOccluders(origins, sun, 0.001F, 8, eight);
        for (std::size_t i = 0; i < 16; ++i) {
            EXPECT_EQ(one[i].distanceM > 0, scene.occluded(origins[i], sun));
            EXPECT_EQ(one[i].distanceM, three[i * 3].distanceM);
            for (std::size_t k = 0; k < 3; ++k)
                EXPECT_EQ(three[i * 3 + k].distanceM, eight[i * 8 + k].distanceM);
        }
    }
}

TEST(InverseAccrualMap, AreaErrorOfADayUnderOnePercentAtThreeLevels) {
    for (std::uint32_t seed = 1; seed <= 3; ++seed) {
        const City city = cityOf(randomBoxes(seed, 10));
        const Receivers receivers = receiversOver(city, -10, -10, 210, 210);
        const SunSteps sun = oneDay(arc(720, 50));
        EXPECT_LT(areaErrorPercent(accrued(city, receivers, sun, {}), traced(city, receivers, sun)), 1)
            << seed;
    }
}

// A 200 m square of a city at a random hour of a random day, including dawn and dusk.
struct RandomHour {
    Receivers receivers;
    SunSteps sun;

    RandomHour(const City& city, std::mt19937& random) {
        const auto between = [&](double low, double high) {
            return std::uniform_real_distribution<double>(low, high)(random);
        };
        const Box2 box = bounds(city);
        const double west = between(box.low.x + 200, box.high.x - 400);
        const double south = between(box.low.y + 200, box.high.y - 400);
        receivers = receiversOver(city, float(west), float(south), float(west + 200), float(south + 200));
        while (sun.steps.size() < 30) {
            const Period period{.start = std::chrono::sys_days(std::chrono::January / 1 / 2026) +
                                         std::chrono::days(int(between(0, 365))),
                                .from = std::chrono::minutes(int(between(4 * 60, 20 * 60))),
                                .hours = 1,
                                .zone = "America/New_York"};
            sun = computeSunSteps(period, {.place = city.frame.origin()}).value();
        }
    }
};

TEST(InverseAccrualMap, AreaErrorOverRandomHoursAndPlacesByLevel) {
    const City city = makeGridSample({.buildings = 2500}).value();
    std::mt19937 random(21);
    std::vector<std::vector<double>> errors(6);
    for (int round = 0; round < 16; ++round) {
        const RandomHour hour(city, random);
        const ShadowField truth = traced(city, hour.receivers, hour.sun);
        for (int levels = 1; levels <= 6; ++levels)
            errors[std::size_t(levels - 1)].push_back(
                areaErrorPercent(accrued(city, hour.receivers, hour.sun, {.levels = levels}), truth));
    }
    for (int levels = 3; levels <= 6; ++levels) {
        std::vector<double>& sorted = errors[std::size_t(levels - 1)];
        std::ranges::sort(sorted);
        EXPECT_LT(std::accumulate(sorted.begin(), sorted.end(), 0.0) / double(sorted.size()), 1) << levels;
        EXPECT_LE(sorted[sorted.size() / 2], 0.7) << levels;
        EXPECT_LE(sorted.back(), 2.6) << levels;
    }
    const auto sum = [](const std::vector<double>& all) {
        return std::accumulate(all.begin(), all.end(), 0.0);
    };
    EXPECT_GT(sum(errors[0]), sum(errors[2]));  // one level is not enough
}

// Lines from far away pass more occluders than there are levels, so they miss a low tower behind many walls.
TEST(InverseAccrualMap, ASunAtTheHorizonIsTraced) {
    const City city = makeGridSample({.buildings = 400}).value();
    const Receivers receivers = receiversOver(city, -500, -100, -300, 100);
    std::vector<Sun> dawn;
    for (int minute = 0; minute < 60; ++minute) dawn.push_back({80 + minute * 0.16, 0.05 + minute * 0.18});
    const SunSteps sun = oneDay(dawn);
    const ShadowField truth = traced(city, receivers, sun);
    EXPECT_LT(areaErrorPercent(accrued(city, receivers, sun, {}), truth), 1.5);
    EXPECT_GT(areaErrorPercent(accrued(city, receivers, sun, {.minSunDeg = 0}), truth), 2.6);
}

// The steps on both sides of the limit are combined in the right order: no step is lost.
TEST(InverseAccrualMap, AnHourThroughTheLimitLosesNoStep) {
    const City city = cityOf({{{0, 0, 0}, {20, 60, 30}}});
    const Receivers receivers = receiversOver(city, -80, -40, 100, 120);
    for (const bool rising : {true, false}) {
        std::vector<Sun> hour;
        for (int minute = 0; minute < 60; ++minute)
            hour.push_back({rising ? 90 + minute * 0.2 : 270 - minute * 0.2, 6 + minute * 0.15});
        if (!rising) std::ranges::reverse(hour);
        const SunSteps sun = oneDay(hour);
        EXPECT_LT(areaErrorPercent(accrued(city, receivers, sun, {}), traced(city, receivers, sun)), 0.5);
    }
}

TEST(InverseAccrualMap, OpenClAndProcessorAgreeBitForBit) {
    const City city = cityOf(randomBoxes(4, 6));
    const Receivers receivers = receiversOver(city, -10, -10, 130, 130);
    const SunSteps sun = oneDay(arc(150, 50));
    const auto withOpenCl = InverseAccrualMap::make({.openClDevice = 0});
    if (!withOpenCl) GTEST_SKIP() << withOpenCl.error().text();
    EXPECT_EQ(computeStatistics(accrued(city, receivers, sun, {.openClDevice = 0})).shadowAreaM2,
              computeStatistics(accrued(city, receivers, sun, {})).shadowAreaM2);
}

TEST(InverseAccrualMap, RefusesSettingsOutOfRange) {
    EXPECT_FALSE(InverseAccrualMap::make({.levels = 0}).has_value());
    EXPECT_FALSE(InverseAccrualMap::make({.levels = 9}).has_value());
    EXPECT_FALSE(InverseAccrualMap::make({.nearestHitM = 0}).has_value());
    EXPECT_FALSE(InverseAccrualMap::make({.marginM = -1}).has_value());
    EXPECT_FALSE(InverseAccrualMap::make({.minSunDeg = 46}).has_value());
    EXPECT_FALSE(InverseAccrualMap::make({.openClDevice = 99}).has_value());
}

}  // namespace
}  // namespace noonmark
