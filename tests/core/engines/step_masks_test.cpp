#include "core/engines/api/step_sets.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>

#include "core/city/city_position.h"
#include "core/engines/auto_engine.h"
#include "core/engines/horizon/horizon_sweep.h"
#include "core/engines/projected/masks/projected_masks.h"
#include "core/engines/projected/projected_shadows.h"
#include "core/engines/ray/ray_reference.h"
#include "core/samples/sample_city.h"
#include "tests/core/engines/scenes.h"
#include "tests/core/engines/terrain_scenes.h"

namespace noonmark {
namespace {

using namespace tests;
using testing::HasSubstr;

using MasksOfDays = std::vector<std::vector<StepMasks>>;  // by day, then by city

Result<MasksOfDays> masksOf(const Engine& engine, const std::vector<const City*>& cities,
                            const Receivers& receivers, const SunSteps& sun) {
    NoProgress quiet;
    MasksOfDays all;
    const auto take = [&](std::size_t day, std::span<StepMasks> masks) -> Result<void> {
        EXPECT_EQ(day, all.size());
        all.emplace_back(masks.begin(), masks.end());
        return {};
    };
    return engine.shadeSteps(cities, receivers, sun, take, quiet, {}).map([&] { return all; });
}

std::size_t countDifferent(const MasksOfDays& a, const MasksOfDays& b) {
    std::size_t bits = 0;
    for (std::size_t day = 0; day < a.size(); ++day)
        for (std::size_t city = 0; city < a[day].size(); ++city)
            for (std::size_t i = 0; i < a[day][city].words.size(); ++i)
                bits += std::size_t(std::popcount(a[day][city].words[i] ^ b[day][city].words[i]));
    return bits;
}

// Receivers in three squares far from each other.
Receivers receiversInSquares(const City& city, double cellM) {
    Region region{"squares", {}};
    for (const glm::vec2 at : {glm::vec2(-300, -200), glm::vec2(10, 30), glm::vec2(220, 300)})
        region.polygons.push_back({rectangle(at.x, at.y, at.x + 71, at.y + 53), {}});
    return placeReceiversOnGround(city, region, {.cellM = cellM}).value();
}

SunSteps sunOver(const City& city, CivilDate start, int days, double stepMinutes) {
    Period period{.start = start, .days = days, .stepMinutes = stepMinutes, .window = SolarHours{}};
    period.zone = "America/New_York";
    return computeSunSteps(period, placeObserver(city, {0, 0})).value();
}

constexpr CivilDate summer{std::chrono::year{2026}, std::chrono::June, std::chrono::day{20}};
constexpr CivilDate december{std::chrono::year{2026}, std::chrono::December, std::chrono::day{20}};

TEST(ReceiverWindows, HoldEveryReceiverOnceAndAreDense) {
    const City city = makeGridSample({.buildings = 300}).value();
    const Receivers receivers = receiversInSquares(city, 1);
    std::vector<int> seen(receivers.cells.size());
    std::size_t cells = 0;
    for (const ReceiverBlock& window : divideIntoBlocks(receivers)) {
        cells += std::size_t(window.east - window.west) * std::size_t(window.band.rows());
        for (const ReceiverRun& run : window.runs)
            for (int i = 0; i < run.count; ++i) {
                ++seen[run.first + std::uint32_t(i)];
                EXPECT_EQ(receivers.cells[run.first + std::uint32_t(i)],
                          receivers.grid.index(run.column + i, run.row));
            }
    }
    EXPECT_TRUE(std::ranges::all_of(seen, [](int times) { return times == 1; }));
    EXPECT_LT(cells, receivers.grid.size() / 4);
}

// Masks of projected shadows are the rasters of its fields, bit for bit; rays may differ within rounding of
// an edge.
TEST(StepMasks, AreTheRastersOfTheFieldAndAgreeWithRays) {
    const City city = makeGridSample({.buildings = 300}).value();
    const Receivers receivers = receiversInSquares(city, 1);
    const SunSteps sun = sunOver(city, december, 1, 3);
    const auto masks = masksOf(ProjectedShadows(), {&city}, receivers, sun).value();
    const auto rasters = computeShadowRasters(city, receivers, sun).value();
    const BitLayout layout(receivers.grid);
    std::size_t shaded = 0;
    for (std::size_t step = 0; step < sun.steps.size(); ++step)
        for (std::size_t i = 0; i < receivers.cells.size(); ++i) {
            const int column = int(receivers.cells[i]) % layout.columns,
                      row = int(receivers.cells[i]) / layout.columns;
            const bool inRaster =
                layout.at(std::span(rasters).subspan(step * layout.words(), layout.words()), column, row);
            ASSERT_EQ(masks[0][0].shaded(step, i), inRaster) << step << ' ' << i;
            shaded += inRaster ? 1 : 0;
        }
    EXPECT_GT(shaded, sun.steps.size() * receivers.cells.size() / 10);
    const auto rays = masksOf(RayReference(), {&city}, receivers, sun).value();
    EXPECT_LE(countDifferent(masks, rays), sun.steps.size() * receivers.cells.size() / 100000);
}

// Two cities that share all buildings but two, in one run and each alone.
TEST(StepMasks, OfSeveralCitiesAreThoseOfEachAlone) {
    const City before = makeGridSample({.buildings = 300}).value();
    City after = before;
    after.buildings.erase(after.buildings.begin() + 17);
    after.buildings.push_back(buildingOf({{30, -20, 0}, {60, 10, 150}}));
    Receivers receivers = receiversInSquares(before, 2);
    const Receivers later = receiversInSquares(after, 2);
    std::erase_if(receivers.cells, [&](std::uint32_t cell) { return !isReceiver(later.kind[cell]); });
    const SunSteps sun = sunOver(before, summer, 3, 7);
    const ProjectedShadows projected;
    const RayReference rays;
    for (const Engine* engine : {static_cast<const Engine*>(&projected), static_cast<const Engine*>(&rays)}) {
        const auto both = masksOf(*engine, {&before, &after}, receivers, sun).value();
        const auto first = masksOf(*engine, {&before}, receivers, sun).value(),
                   second = masksOf(*engine, {&after}, receivers, sun).value();
        ASSERT_EQ(both.size(), 3U);
        for (std::size_t day = 0; day < 3; ++day) {
            EXPECT_EQ(both[day][0], first[day][0]) << engine->name();
            EXPECT_EQ(both[day][1], second[day][0]) << engine->name();
            EXPECT_NE(both[day][0], both[day][1]) << engine->name();
        }
    }
}

TEST(StepMasks, DaysWithoutSunHaveNoSteps) {
    const City city = cityOf({{{0, 0, 0}, {10, 10, 20}}});
    SunSteps sun = oneDay({{180, 30}, {185, 30}});
    sun.days.insert(sun.days.begin(), SunDay{});
    sun.days.push_back({.first = 2});
    const Receivers receivers = receiversOver(city, -20.3F, -20.3F, 40.7F, 40.7F);
    for (const auto& masks : {masksOf(ProjectedShadows(), {&city}, receivers, sun).value(),
                              masksOf(RayReference(), {&city}, receivers, sun).value()}) {
        ASSERT_EQ(masks.size(), 3U);
        EXPECT_EQ(masks[0][0].steps, 0U);
        EXPECT_EQ(masks[1][0].steps, 2U);
        EXPECT_EQ(masks[2][0].steps, 0U);
    }
    const SunSteps night{.days = {SunDay{}}};
    EXPECT_EQ(masksOf(ProjectedShadows(), {&city}, receivers, night).value().size(), 1U);
}

TEST(StepMasks, EnginesThatCannotRefuseAndTerrainGoesToRays) {
    const City city = cityOf({{{0, 0, 0}, {10, 10, 20}}});
    const Receivers receivers = receiversOver(city, -20.3F, -20.3F, 40.7F, 40.7F);
    const SunSteps sun = oneDay({{180, 30}});
    const auto refused = masksOf(HorizonSweep(), {&city}, receivers, sun);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().kind, ErrorKind::unsupported);
    City hill = city;
    hill.terrain = terrainOf(20, 10, [](glm::dvec2 at) { return 3 + at.x / 100; });
    EXPECT_FALSE(masksOf(ProjectedShadows(), {&hill}, receivers, sun));
    const Receivers there = receiversOver(hill, -20.3F, -20.3F, 40.7F, 40.7F);
    const auto rays = masksOf(RayReference(), {&hill}, there, sun).value();
    EXPECT_EQ(masksOf(AutoEngine(), {&hill}, there, sun).value(), rays);
}

TEST(StepMasks, AnErrorOfTheTakerAndAStopRequestEndTheRun) {
    const City city = makeGridSample({.buildings = 100}).value();
    const Receivers receivers = receiversInSquares(city, 2);
    const SunSteps sun = sunOver(city, december, 4, 30);
    NoProgress quiet;
    const City* const cities[]{&city};
    int taken = 0;
    const auto failing = [&](std::size_t, std::span<StepMasks>) -> Result<void> {
        ++taken;
        return failure("enough");
    };
    const ProjectedShadows projected;
    EXPECT_THAT(projected.shadeSteps(cities, receivers, sun, failing, quiet, {}).error().what,
                HasSubstr("enough"));
    EXPECT_EQ(taken, 1);
    std::stop_source source;
    source.request_stop();
    const auto none = [](std::size_t, std::span<StepMasks>) -> Result<void> { return {}; };
    EXPECT_TRUE(
        isCancelled(projected.shadeSteps(cities, receivers, sun, none, quiet, source.get_token()).error()));
    EXPECT_TRUE(isCancelled(
        RayReference().shadeSteps(cities, receivers, sun, none, quiet, source.get_token()).error()));
}

}  // namespace
}  // namespace noonmark
