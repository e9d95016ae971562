#include "core/engines/horizon/cache/horizon_cache.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <mutex>
#include <random>
#include <set>

#include "tests/core/engines/horizon_cache_scenes.h"
#include "tests/core/engines/random_edits.h"
#include "tests/core/engines/terrain_scenes.h"

namespace noonmark {
namespace {

using namespace tests;

TEST(HorizonCache, AgreeWithTheSweepAndWithRays) {
    const City city = blocks(1, 5);
    const Receivers receivers = smallRegion(city, 2);
    const SunSteps sun = someDays(40, 4);
    NoProgress progress;
    const ShadowField cache = fresh(city, receivers, sun), truth = traced(city, receivers, sun),
                      swept = HorizonSweep({.binDeg = cachedBinDeg})
                                  .accumulate(city, receivers, sun, progress, {})
                                  .value();
    double ofSweep = 0, ofRays = 0;
    for (const std::uint32_t cell : receivers.cells) {
        ofSweep += double(std::abs(cache.grossMin[cell] - swept.grossMin[cell]));
        ofRays += double(std::abs(cache.grossMin[cell] - truth.grossMin[cell]));
    }
    const double whole = double(receivers.cells.size()) * truth.sunlitMinutesPerDay;
    EXPECT_LE(ofSweep / whole, 0.004);
    EXPECT_LE(ofRays / whole, 0.006);
}

TEST(HorizonCache, OtherDatesHoursAndStepsAreAsIfFresh) {
    const City city = blocks(2, 5);
    const Receivers receivers = smallRegion(city);
    HorizonCache cache = cachedOf(city, receivers);
    const std::vector<SunSteps> periods{someDays(50, 2), someDays(20, 5), oneDay({{100, 12}, {200, 60}}),
                                        oneDay(arc(400, 35, true)), someDays(50, 2)};
    for (const SunSteps& sun : periods)
        EXPECT_TRUE(sameField(retimed(cache, sun), fresh(city, receivers, sun)));
}

TEST(HorizonCache, CachedBinsAreNotSweptAgain) {
    const City city = blocks(2, 3);
    HorizonCache cache = cachedOf(city, smallRegion(city));
    const char* reason = "azimuth bins in the cache (bins x tiles)";
    EXPECT_EQ(retimed(cache, someDays(30, 3)).cost.skipped.at(reason), 0U);
    EXPECT_GT(retimed(cache, someDays(40, 2)).cost.skipped.at(reason), 100U);
    EXPECT_EQ(retimed(cache, oneDay({{181.2, 60}})).cost.skipped.at(reason), 1U);
    EXPECT_EQ(retimed(cache, oneDay({{181.2, 1}})).cost.skipped.at(reason), 0U);
}

TEST(HorizonCache, TheSweepOfOneTileSaysHowFarItIs) {
    class Heard final : public Progress {
    public:
        void report(double fraction, std::string_view) override {
            const std::scoped_lock lock(mutex_);
            fractions.insert(fraction);
        }
        std::set<double> fractions;

    private:
        std::mutex mutex_;
    } heard;
    const City city = blocks(2, 3);
    HorizonCache cache = cachedOf(city, smallRegion(city));
    ASSERT_TRUE(cache.computePeriod(someDays(30, 3), heard, {}, ShadowCounts::gross));
    EXPECT_GT(heard.fractions.size(), 50U);
    EXPECT_GT(*heard.fractions.begin(), 0);
    EXPECT_EQ(*heard.fractions.rbegin(), 1);
}

TEST(HorizonCache, TerrainThatBecomesAnotherIsSweptAnew) {
    City city = blocks(7, 3);
    const SunSteps sun = someDays(30, 2);
    HorizonCache cache = cachedOf(city, smallRegion(city));
    retimed(cache, sun);
    city.terrain = terrainOf(40, 6, RandomHills(4));
    EXPECT_TRUE(sameField(changed(cache, city, smallRegion(city)), fresh(city, smallRegion(city), sun)));
    city.terrain = terrainOf(40, 6, RandomHills(5));
    EXPECT_TRUE(sameField(changed(cache, city, smallRegion(city)), fresh(city, smallRegion(city), sun)));
}

/// Mean difference from the rays over the receivers, as a share of the period.
double offRays(const City& city, const Receivers& receivers, const SunSteps& sun) {
    const ShadowField cache = fresh(city, receivers, sun), truth = traced(city, receivers, sun);
    double off = 0;
    for (const std::uint32_t cell : receivers.cells)
        off += double(std::abs(cache.grossMin[cell] - truth.grossMin[cell]));
    return off / double(receivers.cells.size()) / truth.sunlitMinutesPerDay;
}

TEST(HorizonCache, WhatHangsAgreesWithRays) {
    const SunSteps sun = someDays(40, 4);
    const auto off = [&](const City& city) { return offRays(city, smallRegion(city, 2), sun); };
    EXPECT_LE(off(cityOf({{{20, 20, 10}, {60, 50, 13}}})), 0.004);
    EXPECT_LE(
        off(cityOf({{{0, 0, 0}, {15, 40, 30}}, {{15, 12, 9}, {35, 20, 15}}, {{35, 0, 0}, {50, 40, 45}}})),
        0.004);
    std::vector<Box3> onStilts{{{30, 30, 12}, {55, 55, 90}}};
    for (const double x : {31.0, 51.0})
        for (const double y : {31.0, 51.0}) onStilts.push_back({{x, y, 0}, {x + 3, y + 3, 12}});
    EXPECT_LE(off(cityOf(onStilts)), 0.004);
}

TEST(HorizonCache, TerrainAgreesWithRays) {
    City city;
    city.terrain = terrainOf(40, 6, RandomHills(4));
    std::mt19937 random(3);
    for (int i = 0; i < 12; ++i) editAnything(city, random, true);
    EXPECT_LE(offRays(city, smallRegion(city, 2), someDays(40, 4)), 0.006);
}

TEST(HorizonCache, LongestRunsMayBeCountedLater) {
    std::mt19937 random(5);
    City city = blocks(6, 3);
    Receivers receivers = smallRegion(city, 4);
    HorizonCache cache = cachedOf(city, receivers);
    NoProgress progress;
    EXPECT_FALSE(cache.withRuns(progress, {}));
    const std::vector<SunSteps> periods{someDays(25, 3), someDays(25, 2), someDays(50, 2)};
    for (int round = 0; round < 60; ++round) {
        const SunSteps& sun = periods[std::size_t(round) % periods.size()];
        cache.computePeriod(sun, progress, {}, ShadowCounts::gross).value();
        editAnything(city, random);
        receivers = smallRegion(city, 4);
        const ShadowField gross = cache.change(city, receivers, progress, {}, ShadowCounts::gross).value();
        const ShadowField whole = fresh(city, receivers, sun);
        ASSERT_TRUE(sameBits(gross.grossMin, whole.grossMin)) << round;
        ASSERT_TRUE(
            std::ranges::all_of(gross.continuousMin, [](float minutes) { return std::isnan(minutes); }));
        if (round % 3 == 1) continue;
        ASSERT_TRUE(sameField(cache.withRuns(progress, {}).value(), whole)) << round;
    }
}

TEST(HorizonCache, TilesBeyondTheMemoryAreSweptAnew) {
    const City city = blocks(4, 4);
    const Receivers receivers = receiversOver(city, -60, -60, 330, 330);
    HorizonCache cache = cachedOf(city, receivers, 12 << 20);
    const SunSteps sun = someDays(30, 2);
    EXPECT_TRUE(sameField(retimed(cache, sun), fresh(city, receivers, sun)));
    EXPECT_LE(cache.bytes(), 12U << 20U);
    EXPECT_GT(cache.bytes(), 0U);
    City less = city;
    less.buildings.pop_back();
    const Receivers open = receiversOver(less, -60, -60, 330, 330);
    EXPECT_TRUE(sameField(changed(cache, less, open), fresh(less, open, sun)));
}

TEST(HorizonCache, RefuseWhatTheyCannotDo) {
    const City city = blocks(5, 2);
    const Receivers receivers = smallRegion(city);
    HorizonCache cache = cachedOf(city, receivers);
    NoProgress progress;
    EXPECT_NE(cache.change(city, receivers, progress, {}).error().text().find("period"), std::string::npos);
    retimed(cache, someDays(40, 1));
    EXPECT_NE(
        cache.change(city, receiversOver(city, 0, 0, 30, 30), progress, {}).error().text().find("region"),
        std::string::npos);
    City laden = city;
    for (int i = 0; i <= 50'000; ++i) laden.buildings.push_back(buildingOf({{0, 0, 5}, {10, 10, 10}}));
    EXPECT_NE(cache.change(laden, receivers, progress, {}).error().text().find("overhanging prisms"),
              std::string::npos);
    EXPECT_TRUE(sameField(changed(cache, city, receivers), fresh(city, receivers, someDays(40, 1))));
    NoProgress silent;
    EXPECT_FALSE(cachedOf(laden, receivers).computePeriod(someDays(40, 1), silent, {}));
}

TEST(HorizonCache, WhatHangsOutOfReachIsNotCounted) {
    const City city = blocks(5, 2);
    const Receivers receivers = smallRegion(city);
    City laden = city;
    for (int i = 0; i <= 50'000; ++i) laden.buildings.push_back(buildingOf({{9000, 0, 5}, {9010, 10, 10}}));
    const SunSteps sun = someDays(40, 1);
    const ShadowField bare = fresh(city, receivers, sun);
    EXPECT_TRUE(sameField(fresh(laden, receivers, sun), bare));
    HorizonCache cache = cachedOf(city, receivers);
    retimed(cache, sun);
    EXPECT_TRUE(sameField(changed(cache, laden, receivers), bare));
    laden.buildings.push_back(buildingOf({{40, 0, 30}, {60, 100, 35}}));
    EXPECT_TRUE(sameField(changed(cache, laden, receivers), fresh(laden, receivers, sun)));
}

TEST(HorizonCache, AfterAStopTheyAreWholeAgain) {
    const City city = blocks(5, 3);
    const Receivers receivers = smallRegion(city);
    HorizonCache cache = cachedOf(city, receivers);
    std::stop_source source;
    source.request_stop();
    NoProgress progress;
    EXPECT_TRUE(isCancelled(cache.computePeriod(someDays(40, 1), progress, source.get_token()).error()));
    EXPECT_TRUE(sameField(retimed(cache, someDays(40, 1)), fresh(city, receivers, someDays(40, 1))));
    City less = city;
    less.buildings.pop_back();
    EXPECT_TRUE(isCancelled(cache.change(less, smallRegion(less), progress, source.get_token()).error()));
    EXPECT_TRUE(sameField(retimed(cache, someDays(40, 1)), fresh(less, smallRegion(less), someDays(40, 1))));
}

}  // namespace
}  // namespace noonmark
