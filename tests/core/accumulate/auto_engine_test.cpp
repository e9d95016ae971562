#include "core/accumulate/auto_engine.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/core/accumulate/scenes.h"

namespace noonmark {
namespace {

using namespace tests;
using testing::HasSubstr;

City oneTower() { return cityOf({{{0, 0, 0}, {20, 20, 30}}}); }

SunSteps days(int count, int stepsADay) {
    SunSteps sun;
    for (int day = 0; day < count; ++day) addDay(sun, arc(stepsADay, 45));
    return sun;
}

/// A strip from south to north: many rows, few receivers.
ShadowField byAuto(const City& city, const SunSteps& sun, std::stop_token stop = {}) {
    NoProgress progress;
    return AutoEngine(0.5)
        .accumulate(city, receiversOver(city, 30, -200, 32, 200), sun, progress, std::move(stop))
        .value();
}

TEST(AutoEngine, aDayOnFlatGroundGoesToProjectedShadows) {
    const ShadowField field = byAuto(oneTower(), days(1, 60));
    EXPECT_EQ(field.engineKey, "projected");
    EXPECT_THAT(field.engine, HasSubstr("Projected shadows"));
    EXPECT_THAT(field.engine, HasSubstr("chosen: projected shadows, exact and quick enough"));
}

TEST(AutoEngine, aLongPeriodGoesToTheHorizonSweep) {
    const ShadowField field = byAuto(oneTower(), days(60, 480));
    EXPECT_EQ(field.engineKey, "horizon");
    EXPECT_THAT(field.engine, HasSubstr("since the period is long"));
}

City onTerrain() {
    City city = oneTower();
    city.terrain =
        std::make_shared<const Terrain>(Terrain{{-300, -300, 100, 7, 7}, std::vector<float>(49, 1)});
    return city;
}

TEST(AutoEngine, aDayOnTerrainGoesToRays) {
    const ShadowField field = byAuto(onTerrain(), days(1, 60));
    EXPECT_EQ(field.engineKey, "ray");
    EXPECT_THAT(field.engine, HasSubstr("terrain"));
}

TEST(AutoEngine, aLongPeriodOnTerrainGoesToTheHorizonSweep) {
    NoProgress progress;
    const City city = onTerrain();
    const auto field =
        AutoEngine(0.5).accumulate(city, receiversOver(city, 30, -200, 60, 200), days(60, 480), progress, {});
    ASSERT_TRUE(field);
    EXPECT_EQ(field->engineKey, "horizon");
}

TEST(AutoEngine, whatTheChosenOneRefusesGoesToRaysAndIsSaid) {
    const ShadowField field = byAuto(oneTower(), days(1, 40'000));  // more than the sweep counts in a day
    EXPECT_EQ(field.engineKey, "ray");
    EXPECT_THAT(field.engine, HasSubstr("refused"));
    EXPECT_THAT(field.engine, HasSubstr("40000 steps"));
}

TEST(AutoEngine, aStopIsNoRefusal) {
    std::stop_source stop;
    stop.request_stop();
    NoProgress progress;
    const City city = oneTower();
    const auto field = AutoEngine(0.5).accumulate(city, receiversOver(city, 0, 0, 40, 40), days(1, 9),
                                                  progress, stop.get_token());
    ASSERT_FALSE(field);
    EXPECT_TRUE(isCancelled(field.error()));
}

}  // namespace
}  // namespace noonmark
