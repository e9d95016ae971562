#include "core/engines/horizon/horizon_sweep.h"

#include <gtest/gtest.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/core/engines/scenes.h"

namespace noonmark {
namespace {

using namespace tests;

ShadowField swept(const City& city, const Receivers& receivers, const SunSteps& sun, double binDeg = 0.5) {
    NoProgress progress;
    return HorizonSweep({.binDeg = binDeg}).accumulate(city, receivers, sun, progress, {}).value();
}

City standingBoxes(std::uint32_t seed, int perSide) {
    std::vector<Box3> boxes = randomBoxes(seed, perSide);
    for (Box3& box : boxes) box.low.z = 0;
    return cityOf(boxes);
}

/// Differences from the ray reference, in percent of the period.
struct Errors {
    double mean = 0, max = 0;
};

Errors errorsOf(const ShadowField& field, const ShadowField& truth, const Receivers& receivers) {
    Errors errors;
    for (const std::uint32_t cell : receivers.cells) {
        const double error =
            100 * std::abs(double(field.grossMin[cell] - truth.grossMin[cell])) / truth.sunlitMinutesPerDay;
        errors.mean += error / double(receivers.cells.size());
        errors.max = std::max(errors.max, error);
    }
    return errors;
}

TEST(HorizonSweep, AgreesWithRaysOnDaysOfAYear) {
    for (std::uint32_t seed = 1; seed <= 2; ++seed) {
        const City city = standingBoxes(seed, 6);
        const Receivers receivers = receiversOver(city, -20.3F, -20.3F, 140.7F, 140.7F, 2);
        const SunSteps sun = days(seed == 1 ? 40.7 : -33.9, 6, 2);
        const Errors errors = errorsOf(swept(city, receivers, sun), traced(city, receivers, sun), receivers);
        EXPECT_LE(errors.mean, 0.05) << seed;
        EXPECT_LE(errors.max, 0.5) << seed;
    }
}

TEST(HorizonSweep, ErrorsVanishAsBinsNarrow) {
    const City city = standingBoxes(3, 5);
    const Receivers receivers = receiversOver(city, -20.3F, -20.3F, 120.7F, 120.7F, 2);
    const SunSteps sun = days(51, 12);
    const ShadowField truth = traced(city, receivers, sun);
    const double coarse = errorsOf(swept(city, receivers, sun, 2), truth, receivers).mean,
                 middle = errorsOf(swept(city, receivers, sun, 0.5), truth, receivers).mean,
                 fine = errorsOf(swept(city, receivers, sun, 0.1), truth, receivers).mean;
    EXPECT_LT(middle, coarse / 2);
    EXPECT_LT(fine, middle / 2);
    EXPECT_LT(fine, 0.02);
}

TEST(HorizonSweep, AgreesWithRaysOnCourtyardsAndConcaveParts) {
    City city;
    const Ring court = rectangle(10, 10, 20, 22);
    city.buildings.push_back(
        buildingOf({rectangle(0, 0, 30, 30), {Ring(court.rbegin(), court.rend())}}, 0, 12));
    city.buildings.push_back(
        buildingOf({{{50, 0}, {80, 0}, {80, 10}, {60, 10}, {60, 30}, {50, 30}}, {}}, 0, 25));
    city.buildings.push_back(buildingOf({{{0, 50}, {30, 53}, {28, 80}, {15, 60}, {2, 82}}, {}}, 0, 20));
    const Receivers receivers = receiversOver(city, -40.3F, -40.3F, 130.7F, 130.7F);
    const SunSteps sun = days(40.7, 30, 2);
    const Errors errors = errorsOf(swept(city, receivers, sun), traced(city, receivers, sun), receivers);
    EXPECT_LE(errors.mean, 0.1);
    EXPECT_LE(errorsOf(swept(city, receivers, sun, 0.1), traced(city, receivers, sun), receivers).mean, 0.03);
}

TEST(HorizonSweep, ATowerOnAPodiumStandsOnTheGround) {
    const auto podium = buildingOf({rectangle(0, 0, 40, 40), {}}, 0, 10);
    Building building = *podium;
    building.parts.push_back(buildingOf({rectangle(10, 10, 30, 30), {}}, 10, 60)->parts.front());
    City city;
    city.buildings.push_back(std::make_shared<const Building>(building));
    const Receivers receivers = receiversOver(city, -100.3F, -100.3F, 140.7F, 140.7F, 2);
    const SunSteps sun = oneDay(arc(300, 50));
    EXPECT_LE(errorsOf(swept(city, receivers, sun, 0.1), traced(city, receivers, sun), receivers).mean, 0.05);
}

// South of a long wall the sun is never hidden. North of a wall of height z, at distance d, a sun in the
// south is hidden if tan(altitude) < z / d.
TEST(HorizonSweep, ALongWallHidesTheLowSun) {
    const City city = cityOf({{{-5000, 0, 0}, {5000, 10, 20}}});
    const Receivers receivers = receiversOver(city, -10, -50, 10, 150);
    std::vector<Sun> suns;
    for (int i = 0; i < 120; ++i) suns.push_back({180, 2 + 0.5 * i});
    const ShadowField field = swept(city, receivers, oneDay(suns));
    for (const std::uint32_t cell : receivers.cells) {
        const double north = double(receivers.position(cell).y) - 10;
        // A sun's altitude is rounded by up to 0.001 deg.
        const auto hiddenAt = [&](double offDeg) {
            return double(std::ranges::count_if(suns, [&](const Sun& sun) {
                return north > 0 &&
                       std::tan((sun.altitudeDeg + offDeg) * std::numbers::pi / 180) < 20 / north;
            }));
        };
        EXPECT_GE(double(field.grossMin[cell]), hiddenAt(0.001) - 1e-3) << north;
        EXPECT_LE(double(field.grossMin[cell]), hiddenAt(-0.001) + 1e-3) << north;
        EXPECT_EQ(field.continuousMin[cell], field.grossMin[cell]) << north;
    }
}

// The sun in the north, with azimuths from 350 through 0 to 10; in the tropics, where its azimuth reverses;
// and where it never sets.
TEST(HorizonSweep, AzimuthsWrapTurnBackAndGoAllTheWayRound) {
    const City city = standingBoxes(4, 4);
    const Receivers receivers = receiversOver(city, -30.3F, -30.3F, 110.7F, 110.7F, 2);
    std::vector<Sun> wrap, tropics, polar;
    for (int i = 0; i < 200; ++i) wrap.push_back({std::fmod(350 + 0.1 * i, 360), 20});
    for (int i = 0; i < 300; ++i) {
        const double t = (i - 150) / 150.0;
        tropics.push_back({70 - 20 * (1 - t * t), 10 + 70 * (1 - std::abs(t))});
    }
    for (int i = 0; i < 720; ++i) polar.push_back({0.5 * i, 15 - 8 * std::cos(i * std::numbers::pi / 360)});
    for (const auto& suns : {wrap, tropics, polar}) {
        const SunSteps sun = oneDay(suns);
        const Errors errors =
            errorsOf(swept(city, receivers, sun, 0.2), traced(city, receivers, sun), receivers);
        EXPECT_LE(errors.mean, 0.2) << suns.size();
        EXPECT_LE(errors.max, 5) << suns.size();
    }
}

TEST(HorizonSweep, ASunInTheZenithIsHiddenFromNobody) {
    const City city = standingBoxes(4, 2);
    const Receivers receivers = receiversOver(city, -30.3F, -30.3F, 60.7F, 60.7F);
    const ShadowField field = swept(city, receivers, oneDay({{0, 90}, {180, 89.99}}));
    for (const std::uint32_t cell : receivers.cells) EXPECT_EQ(field.grossMin[cell], 0);
}

// On the eastern and northern walls of a building a receiver is dark with the sun behind the building; on the
// other walls the cell is under the building.
TEST(HorizonSweep, ReceiversOnAWallStandInItsShadow) {
    const City city = cityOf({{{0.5, 0.5, 0}, {20.5, 20.5, 10}}});
    const Receivers receivers = receiversOver(city, -10, -10, 40, 40);
    const SunSteps sun = oneDay({{265, 80}, {200, 80}, {91, 5}, {10, 5}});
    const ShadowField field = swept(city, receivers, sun), truth = traced(city, receivers, sun);
    for (const std::uint32_t cell : receivers.cells)
        EXPECT_EQ(field.grossMin[cell], truth.grossMin[cell]) << cell;
    EXPECT_EQ(field.grossMin[cellAt(receivers.grid, 20.5, 10.5)], 2);
    EXPECT_EQ(field.grossMin[cellAt(receivers.grid, 10.5, 20.5)], 3);
}

TEST(HorizonSweep, ReceiversHalfAMillimetreFromAWallStandInItsShadow) {
    const City city = cityOf({{{10.5004, 10.5004, 0}, {30, 30, 10}}});
    const Receivers receivers = receiversOver(city, 0, 0, 40, 40);
    const SunSteps sun = oneDay({{20, 30}, {45, 60}, {70, 5}, {85, 80}, {225, 30}});
    const ShadowField field = swept(city, receivers, sun);
    EXPECT_EQ(field.grossMin[cellAt(receivers.grid, 10.5, 20.5)], 4);
    EXPECT_EQ(field.grossMin[cellAt(receivers.grid, 20.5, 10.5)], 4);
}

TEST(HorizonSweep, PartyWallsLetNoLightThrough) {
    const City whole = cityOf({{{0, 0, 0}, {40, 20, 30}}});
    const City halves = cityOf({{{0, 0, 0}, {17, 20, 30}}, {{17, 0, 0}, {40, 20, 30}}});
    const Receivers receivers = receiversOver(whole, -60, -60, 100, 100);
    const SunSteps sun = days(40.7, 60);
    const ShadowField one = swept(whole, receivers, sun), two = swept(halves, receivers, sun);
    for (const std::uint32_t cell : receivers.cells) {
        EXPECT_NEAR(one.grossMin[cell], two.grossMin[cell], 1e-3) << cell;
        EXPECT_NEAR(one.continuousMin[cell], two.continuousMin[cell], 1e-3) << cell;
    }
}

// Cells whose centres are in line with the sun and with the joint of two walls: shadows that run almost along
// a row of cells.
TEST(HorizonSweep, NoLightPassesWhereTwoWallsMeetInLineWithTheSun) {
    const City whole = cityOf({{{0, 0, 0}, {10, 50, 30}}}),
               halves = cityOf({{{0, 0, 0}, {10, 20.5, 30}}, {{0, 20.5, 0}, {10, 50, 30}}});
    const Receivers receivers = receiversOver(whole, -60, 5, 70, 45);
    const SunSteps sun = oneDay({{90, 10}, {90, 30}, {270, 10}, {270, 30}});
    const ShadowField one = swept(whole, receivers, sun), two = swept(halves, receivers, sun);
    for (const std::uint32_t cell : receivers.cells)
        ASSERT_EQ(one.grossMin[cell], two.grossMin[cell]) << cell;
}

TEST(HorizonSweep, TheAnswerDoesNotDependOnThreads) {
    const City city = standingBoxes(5, 5);
    const Receivers receivers = receiversOver(city, -20.3F, -20.3F, 120.7F, 120.7F);
    const SunSteps sun = days(40.7, 60);
    const ShadowField all = swept(city, receivers, sun);
    tbb::task_arena alone(1);
    const ShadowField one = alone.execute([&] { return swept(city, receivers, sun); });
    for (const std::uint32_t cell : receivers.cells) {
        EXPECT_EQ(all.grossMin[cell], one.grossMin[cell]);
        EXPECT_EQ(all.continuousMin[cell], one.continuousMin[cell]);
    }
    for (std::size_t cell = 0; cell < receivers.kind.size(); ++cell)
        EXPECT_EQ(std::isnan(all.grossMin[cell]), receivers.kind[cell] != CellKind::ground);
}

// A distant part of the region changes the division into tiles and nothing else.
TEST(HorizonSweep, TilesAgreeWithOneAnother) {
    const City city = standingBoxes(6, 4);
    const Receivers wide = receiversOver(city, -1500, 0, 100, 60), near = receiversOver(city, 0, 0, 100, 60);
    const SunSteps sun = days(40.7, 90, 5);
    const ShadowField all = swept(city, wide, sun), part = swept(city, near, sun);
    std::size_t different = 0;
    for (const std::uint32_t cell : near.cells) {
        const glm::vec3 place = near.position(cell);
        const std::size_t other = cellAt(wide.grid, double(place.x), double(place.y));
        different += std::abs(all.grossMin[other] - part.grossMin[cell]) > 1e-3F;
    }
    EXPECT_LE(different, near.cells.size() / 200);
}

TEST(HorizonSweep, NoSunAndNoCityGiveZeros) {
    const City city = cityOf({{{0, 0, 0}, {10, 10, 10}}});
    const Receivers receivers = receiversOver(city, -20, -20, 20, 20);
    SunSteps night;
    night.days.push_back({});
    const ShadowField dark = swept(city, receivers, night), empty = swept({}, receivers, oneDay(arc(10, 40)));
    for (const std::uint32_t cell : receivers.cells) {
        EXPECT_EQ(dark.grossMin[cell], 0);
        EXPECT_EQ(empty.grossMin[cell], 0);
        EXPECT_EQ(empty.continuousMin[cell], 0);
    }
}

Error refusal(const City& city, const SunSteps& sun, double binDeg = 0.5) {
    NoProgress progress;
    return HorizonSweep({.binDeg = binDeg})
        .accumulate(city, receiversOver(city, -20, -20, 40, 40), sun, progress, {})
        .error();
}

TEST(HorizonSweep, RefusesWhatAHorizonCannotSay) {
    const City box = cityOf({{{0, 0, 0}, {10, 10, 10}}});
    const SunSteps sun = oneDay(arc(10, 40));
    Part mesh = box.buildings[0]->parts[0];
    TriangleMesh fine;
    for (std::uint32_t i = 0; i < 5000; ++i) {
        const TriangleMesh part = meshOf(mesh);
        for (const glm::uvec3& triangle : part.triangles)
            fine.triangles.push_back(triangle + std::uint32_t(fine.vertices.size()));
        fine.vertices.insert(fine.vertices.end(), part.vertices.begin(), part.vertices.end());
    }
    mesh.mesh = std::make_shared<const TriangleMesh>(fine);
    mesh.isOverhanging = true;
    City meshes;
    meshes.buildings.push_back(std::make_shared<const Building>(Building{.parts = {mesh}}));
    EXPECT_NE(refusal(meshes, sun).text().find("triangles"), std::string::npos);
    for (const double width : {0.09, 2.1, std::nan("")})
        EXPECT_NE(refusal(box, sun, width).text().find("0.1 to 2"), std::string::npos) << width;
    EXPECT_NE(refusal(box, oneDay(arc(32'768, 40))).text().find("step"), std::string::npos);
}

TEST(HorizonSweep, RefusesErrorTargetsOutOfRange) {
    const City city = cityOf({{{0, 0, 0}, {10, 10, 10}}});
    NoProgress progress;
    for (const double percent : {0.0, 0.0049, 1.01, std::nan("")}) {
        const auto refused =
            HorizonSweep({.errorTargetPercent = percent})
                .accumulate(city, receiversOver(city, -20, -20, 40, 40), oneDay(arc(10, 40)), progress, {});
        ASSERT_FALSE(refused) << percent;
        EXPECT_NE(refused.error().text().find("0.005 to 1 %"), std::string::npos);
    }
}

TEST(HorizonSweep, TakesAHangingPartOutOfReach) {
    const City city = cityOf({{{0, 0, 0}, {10, 10, 10}}, {{5000, 0, 5}, {5010, 10, 10}}});
    const Receivers receivers = receiversOver(city, -20, -20, 40, 40);
    EXPECT_EQ(swept(city, receivers, oneDay({{90, 30}})).cost.buildingsUsed, 1U);
}

TEST(HorizonSweep, StopsWhenAsked) {
    const City city = standingBoxes(5, 3);
    const Receivers receivers = receiversOver(city, -20, -20, 80, 80);
    std::stop_source source;
    source.request_stop();
    NoProgress progress;
    const auto stopped =
        HorizonSweep().accumulate(city, receivers, oneDay(arc(60, 40)), progress, source.get_token());
    ASSERT_FALSE(stopped.has_value());
    EXPECT_TRUE(isCancelled(stopped.error()));
}

}  // namespace
}  // namespace noonmark
