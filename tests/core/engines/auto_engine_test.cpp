#include "core/engines/auto_engine.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/core/engines/scenes.h"

namespace noonmark {
namespace {

using namespace tests;
using testing::HasSubstr;

City oneTower() { return cityOf({{{0, 0, 0}, {20, 20, 30}}}); }

SunSteps evenDays(int count, int stepsADay) {
    SunSteps sun;
    for (int day = 0; day < count; ++day) addDay(sun, arc(stepsADay, 45));
    return sun;
}

/// A strip from south to north: many rows, few receivers.
ShadowField byAuto(const City& city, const SunSteps& sun, std::stop_token stop = {}) {
    NoProgress progress;
    return AutoEngine()
        .accumulate(city, receiversOver(city, 30, -200, 32, 200), sun, progress, std::move(stop))
        .value();
}

TEST(AutoEngine, ADayOnFlatGroundGoesToProjectedShadows) {
    const ShadowField field = byAuto(oneTower(), evenDays(1, 60));
    EXPECT_EQ(field.engineKey, "projected");
    EXPECT_THAT(field.engine, HasSubstr("Projected shadows"));
    EXPECT_THAT(field.engine, HasSubstr("chosen: projected shadows, exact and quick enough"));
}

TEST(AutoEngine, ALongPeriodGoesToTheHorizonSweep) {
    const ShadowField field = byAuto(oneTower(), evenDays(150, 480));
    EXPECT_EQ(field.engineKey, "horizon");
    EXPECT_THAT(field.engine, HasSubstr("since the period is long"));
}

City onTerrain() {
    City city = oneTower();
    city.terrain =
        std::make_shared<const Terrain>(Terrain{{-300, -300, 100, 7, 7}, std::vector<float>(49, 1)});
    return city;
}

TEST(AutoEngine, ADayOnTerrainGoesToRays) {
    const ShadowField field = byAuto(onTerrain(), evenDays(1, 60));
    EXPECT_EQ(field.engineKey, "ray");
    EXPECT_THAT(field.engine, HasSubstr("terrain"));
}

TEST(AutoEngine, ALongPeriodOnTerrainGoesToTheHorizonSweep) {
    NoProgress progress;
    const City city = onTerrain();
    const auto field = AutoEngine().accumulate(city, receiversOver(city, 30, -200, 60, 200),
                                               evenDays(60, 480), progress, {});
    ASSERT_TRUE(field);
    EXPECT_EQ(field->engineKey, "horizon");
}

TEST(AutoEngine, WhatTheChosenOneRefusesGoesToRaysAndIsReported) {
    const ShadowField field = byAuto(oneTower(), evenDays(1, 60'000));  // too many steps for the sweep
    EXPECT_EQ(field.engineKey, "ray");
    EXPECT_THAT(field.engine, HasSubstr("refused"));
    EXPECT_THAT(field.engine, HasSubstr("60000 steps"));
}

// 800 x 800 m in a dense city: receivers, buildings and bins of the grid sample.
EngineLoad denseYear() {
    return {.receivers = 285'679, .rows = 800, .steps = 173'342, .bins = 390, .buildings = 3'000};
}

TEST(AutoEngine, ExpectsTheSweepToWinLongPeriodsInDenseCities) {
    const EstimatedSeconds year = estimateSeconds(denseYear());
    EXPECT_LT(year.horizon * 5, year.projected);
    EXPECT_LT(year.projected, year.ray);
    EngineLoad hour = denseYear();
    hour.steps = hour.bins = 60;
    EXPECT_LT(estimateSeconds(hour).projected, 2);
}

TEST(AutoEngine, ExpectsTheSweepToTakeLongerBelowPartsThatHang) {
    EngineLoad month = denseYear();
    month.steps = 14'400;
    month.bins = 590;
    month.buildings = 950;
    month.overhangTriangles = 1'796;  // from Midtown
    const EstimatedSeconds seconds = estimateSeconds(month);
    EXPECT_LT(seconds.horizon, seconds.projected);
    month.overhangTriangles = 0;
    EXPECT_LT(estimateSeconds(month).horizon * 1.4, seconds.horizon);
}

TEST(AutoEngine, ExpectsGrossShadowAloneToTakeTheSweepLess) {
    EngineLoad year = denseYear();
    const EstimatedSeconds both = estimateSeconds(year);
    year.runs = false;
    EXPECT_LT(estimateSeconds(year).horizon * 1.5, both.horizon);
    EXPECT_EQ(estimateSeconds(year).projected, both.projected);
}

TEST(AutoEngine, LooksAtPartsThatHangInReachOnly) {
    const City city =
        cityOf({{{0, 0, 0}, {10, 10, 10}}, {{30, 0, 5}, {40, 10, 10}}, {{9000, 0, 5}, {9010, 10, 10}}});
    const Receivers receivers = receiversOver(city, -20, -20, 60, 40);
    const City* const cities[]{&city};
    const EngineLoad load = measureEngineLoad(cities, receivers, oneDay(arc(60, 40)), {.binDeg = 1});
    EXPECT_EQ(load.buildings, 2U);
    EXPECT_EQ(load.overhangTriangles, 12U);
    EXPECT_EQ(load.bins, 60U);
    EXPECT_TRUE(load.level);
}

TEST(AutoEngine, GoesOnToAnExactEngineWhereASampleMissesTheTarget) {
    const City level = oneTower(), hills = onTerrain();
    const SunSteps sun = evenDays(150, 480);
    const auto moreExactThan = [&](const City& city, const Receivers& receivers, SampledDeviation off) {
        const City* const cities[]{&city};
        const auto used = AutoEngine().choose(cities, receivers, sun);
        EXPECT_EQ(used->key, "horizon");
        return AutoEngine().chooseMoreExact(*used, off, cities, receivers, sun);
    };
    const Receivers strip = receiversOver(level, 30, -200, 32, 200);
    EXPECT_FALSE(moreExactThan(level, strip, {0.04, 0.004})) << "within the target";
    EXPECT_FALSE(moreExactThan(level, strip, {0.055, 0.004})) << "chance";
    EXPECT_TRUE(moreExactThan(level, strip, {0.11, 0.2})) << "chance explains no more than the target";
    const auto rays = moreExactThan(level, strip, {2.4, 0.2});
    ASSERT_TRUE(rays);
    EXPECT_EQ(rays->key, "ray") << "800 receivers take rays less time than 400 rows take polygons";
    EXPECT_EQ(
        rays->why,
        "rays, since a sample of the horizon sweep is off by 2.400 % of the period in the mean, more than "
        "the 0.05 % aimed at");
    EXPECT_EQ(moreExactThan(level, receiversOver(level, 30, -200, 232, 200), {2.4, 0.2})->key, "projected");
    EXPECT_EQ(moreExactThan(hills, receiversOver(hills, 30, -200, 232, 200), {2.4, 0.2})->key, "ray");
}

TEST(AutoEngine, GoesOnFromNoExactEngineAndFromNoBinsThatWereSet) {
    const City city = oneTower();
    const City* const cities[]{&city};
    const Receivers receivers = receiversOver(city, 30, -200, 32, 200);
    const SunSteps sun = evenDays(150, 480);
    const SampledDeviation far{3, 0.1};
    const EngineChoice exact{"projected", nullptr, ""}, sweep{"horizon", nullptr, ""};
    EXPECT_FALSE(AutoEngine().chooseMoreExact(exact, far, cities, receivers, sun));
    EXPECT_TRUE(AutoEngine().chooseMoreExact(sweep, far, cities, receivers, sun));
    EXPECT_FALSE(AutoEngine({.binDeg = 2}).chooseMoreExact(sweep, far, cities, receivers, sun));
    EXPECT_FALSE(
        AutoEngine({.errorTargetPercent = 1}).chooseMoreExact(sweep, {0.9, 0.1}, cities, receivers, sun));
}

TEST(AutoEngine, AStopIsNoRefusal) {
    std::stop_source stop;
    stop.request_stop();
    NoProgress progress;
    const City city = oneTower();
    const auto field = AutoEngine().accumulate(city, receiversOver(city, 0, 0, 40, 40), evenDays(1, 9),
                                               progress, stop.get_token());
    ASSERT_FALSE(field);
    EXPECT_TRUE(isCancelled(field.error()));
}

TEST(AutoEngine, CanDoWhatTheEnginesItChoosesAmongCanDo) {
    const EngineCapabilities able = AutoEngine().capabilities();
    EXPECT_TRUE(able.terrain && able.roofs) << "rays and the sweep take them";
    EXPECT_TRUE(able.sets && able.attribution && able.cache) << "the sweep has them";
    EXPECT_TRUE(able.overhangs && able.continuous) << "all have them";
    EXPECT_TRUE(able.choosesEngine);
    EXPECT_EQ(able.independence, Independence::none) << "that is the chosen engine's";
    const EngineCapabilities flat = combineForChoice({{.overhangs = false}, {.sets = true}});
    EXPECT_FALSE(flat.terrain || flat.roofs || flat.overhangs || flat.attribution);
    EXPECT_TRUE(flat.sets);
}

}  // namespace
}  // namespace noonmark
