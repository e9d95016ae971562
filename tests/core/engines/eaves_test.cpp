// A roof that overhangs the walls as a sheet lets the sun in below it, in every engine.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/engines/api/engine_registry.h"
#include "core/engines/horizon/attribution/horizon_breakdown.h"
#include "core/engines/horizon/cache/horizon_cache.h"
#include "core/engines/points/point_horizons.h"
#include "core/engines/points/point_sunlight.h"
#include "core/engines/points/sky_obstacles.h"
#include "core/engines/projected/shadow_cache.h"
#include "core/receivers/point_receivers.h"
#include "tests/core/engines/eaves_scenes.h"
#include "tests/core/engines/sweep_scenes.h"

namespace noonmark {
namespace {

using namespace tests;

const EavesHouse eavesHouse{.at = {0.3, 0.2}};

Receivers aroundTheHouse(const City& city) { return receiversOver(city, -30, -30, 40, 40); }
Receivers inTheVillage(const City& city) { return receiversOver(city, -10, -20, 170, 170); }

/// Over all receivers, percent of the time with the sun up: of gross shadow; and of a day: of the longest
/// run.
struct EavesOff {
    double mean = 0, largest = 0, meanRun = 0;
};

EavesOff offBetween(const ShadowField& field, const ShadowField& truth, const Receivers& receivers) {
    EavesOff off;
    const double whole = truth.sunlitMinutesPerDay / 100, count = double(receivers.cells.size());
    for (const std::uint32_t cell : receivers.cells) {
        const double one = std::abs(double(field.grossMin[cell] - truth.grossMin[cell])) / whole;
        off.mean += one / count;
        off.largest = std::max(off.largest, one);
        off.meanRun +=
            std::abs(double(field.continuousMin[cell] - truth.continuousMin[cell])) / whole / count;
    }
    return off;
}

ShadowField byEngine(const char* engine, const City& city, const Receivers& receivers, const SunSteps& sun) {
    NoProgress progress;
    return makeEngine(engine).value()->accumulate(city, receivers, sun, progress, {}).value();
}

TEST(Eaves, OfAHouseShadeAsGeometrySays) {
    const City city = cityOf(std::vector{eavesHouse});
    const Receivers receivers = aroundTheHouse(city);
    ASSERT_EQ(receivers.cells.size(), 70U * 70U - 80U) << "the ground below the eaves is a receiver";
    const SunSteps sun = oneDay(arc(540, 44));
    ShadowField truth = byEngine("ray", city, receivers, sun);
    for (const std::uint32_t cell : receivers.cells) {
        const glm::dvec2 place(glm::vec2(receivers.position(cell)));
        const Minutes minutes = minutesOf(sun, [&](glm::dvec3 to) { return shades(eavesHouse, place, to); });
        ASSERT_NEAR(double(truth.grossMin[cell]), minutes.gross, 3) << place.x << ' ' << place.y;
        truth.grossMin[cell] = float(minutes.gross);
        truth.continuousMin[cell] = float(minutes.continuous);
    }
    for (const char* engine : {"ray", "projected", "auto"}) {
        const EavesOff off = offBetween(byEngine(engine, city, receivers, sun), truth, receivers);
        EXPECT_LE(off.mean, 0.01) << engine;
        EXPECT_LE(off.largest, 0.6) << engine;
    }
    const EavesOff sweep = offBetween(swept(city, receivers, sun), truth, receivers);
    EXPECT_LE(sweep.mean, 0.03);
    EXPECT_LE(sweep.largest, 1);
    EXPECT_LE(sweep.meanRun, 0.05);
}

// In front of the southern wall, 0.7 m from it, at noon: the edge of the eaves, 4.5 m high, is 0.3 m away,
// and hides the sun above atan(4.5 / 0.3) = 86.2 degrees only.
TEST(Eaves, TheSunComesInBelowThem) {
    const City city = cityOf(std::vector{eavesHouse});
    const Receivers receivers = aroundTheHouse(city);
    const auto below = cellAt(receivers.grid, 5.5, -0.5);
    for (const char* engine : {"ray", "projected", "horizon"}) {
        EXPECT_EQ(byEngine(engine, city, receivers, oneDay({{180, 80}})).grossMin[below], 0) << engine;
        EXPECT_EQ(byEngine(engine, city, receivers, oneDay({{180, 87}})).grossMin[below], 1) << engine;
    }
}

TEST(Eaves, OfAVillageAgreeWithRaysOnEveryCell) {
    const City city = cityOf(village());
    const Receivers receivers = inTheVillage(city);
    const SunSteps sun = threeDays();
    const ShadowField truth = traced(city, receivers, sun);
    const EavesOff sweep = offBetween(swept(city, receivers, sun), truth, receivers);
    EXPECT_LE(sweep.mean, 0.05);
    EXPECT_LE(sweep.largest, 2);
    EXPECT_LE(sweep.meanRun, 0.1);
    const EavesOff projected = offBetween(byEngine("projected", city, receivers, sun), truth, receivers);
    EXPECT_LE(projected.mean, 0.002);
    EXPECT_LE(projected.largest, 0.5);
}

TEST(Eaves, OfAVillageAgreeWithRaysInTheCaches) {
    std::vector<EavesHouse> houses = village();
    const City whole = cityOf(houses);
    City fewer = whole;
    fewer.buildings.erase(fewer.buildings.begin() + 20, fewer.buildings.begin() + 24);
    const Receivers receivers = receiversOver(whole, 20, 20, 120, 120);
    const SunSteps sun = threeDays();
    const ShadowField truth = traced(whole, receivers, sun);
    NoProgress progress;
    ShadowCache shadows = ShadowCache::make(fewer, receivers, sun, progress, {}).value();
    ASSERT_TRUE(shadows.change(whole, receivers, progress, {}));
    EXPECT_LE(offBetween(shadows.field(), truth, receivers).mean, 0.002);
    HorizonCache horizons = HorizonCache::make(fewer, receivers, {0.25, std::uint64_t{1} << 30U}).value();
    ASSERT_TRUE(horizons.computePeriod(sun, progress, {}));
    const auto changed = horizons.change(whole, receivers, progress, {});
    ASSERT_TRUE(changed);
    EXPECT_LE(offBetween(*changed, truth, receivers).mean, 0.15);
    EXPECT_LE(offBetween(*changed, truth, receivers).meanRun, 0.5);
}

TEST(Eaves, AreChargedToTheirHouse) {
    const City city = cityOf(village());
    const Receivers receivers = inTheVillage(city);
    const SunSteps sun = threeDays();
    NoProgress progress;
    const ShadowBreakdown breakdown =
        computeHorizonBreakdown(city, receivers, sun, makeOneSet(sun), {.byBuilding = true}, progress, {})
            .value();
    const ShadowField truth = traced(city, receivers, sun);
    double attributed = 0, traced = 0;
    for (const BuildingShadow& one : breakdown.buildings) attributed += one.attributedMinM2.front();
    for (const std::uint32_t cell : receivers.cells)
        traced += double(truth.grossMin[cell]) * double(sun.dayCount());
    EXPECT_EQ(breakdown.buildings.size(), city.buildings.size());
    EXPECT_NEAR(attributed / traced, 1, 5e-3);
}

TEST(Eaves, LeaveTheFacadesBelowThemAndTheirSun) {
    const City city = cityOf(village());
    std::vector<std::uint32_t> all(city.buildings.size());
    std::iota(all.begin(), all.end(), 0U);
    const PointReceivers placed = placeOnFacades(city, all, {.storeyM = 3}).value();
    EXPECT_GT(placed.size(), 49U * 15U) << "each house has some";
    SunSteps sun = days(47.4, 10, 2);
    for (SunDay& day : sun.days) day.date = std::chrono::year(2026) / 3 / 1;
    NoProgress progress;
    const PointMonths swept = sweepPoints(city, placed.points, sun, progress, {}, {.runs = true}).value();
    const PointMonths truth = tracePoints(city, placed.points, sun, progress, {}).value();
    double mean = 0, largest = 0;
    for (std::size_t i = 0; i < placed.size(); ++i) {
        const double one = 100 * std::abs(swept.sunlitOf(i) - truth.sunlitOf(i)) / truth.possibleMin;
        mean += one / double(placed.size());
        largest = std::max(largest, one);
    }
    EXPECT_LE(mean, 0.08);
    EXPECT_LE(largest, 1.5);
}

TEST(Eaves, OfOneHouseLeaveAllItsFacadePoints) {
    const City city = cityOf(std::vector{EavesHouse{.wallM = 6.5}});
    const PointReceivers placed = placeOnFacades(city, std::vector{0U}, {.storeyM = 3}).value();
    // Storeys of 3 m, points at 1.5 and 4.5 m, of the gables at 7.5 m too where they are that high (to 8.5
    // m): 3 bays on 10 m, 3 on 8 m, of the gables' third storey the middle one.
    EXPECT_EQ(placed.size(), 2U * (3 + 3) * 2 + 2);
}

}  // namespace
}  // namespace noonmark
