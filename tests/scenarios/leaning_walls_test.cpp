#include "scenarios/massing/floor_plate.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "core/city/city.h"
#include "core/city/footprints/plan_areas.h"
#include "core/city/meshes/mesh_outline.h"
#include "core/city/meshes/mesh_topology.h"
#include "core/city/terrain/building_ground.h"
#include "core/study/study.h"
#include "scenarios/massing/lot_edits.h"
#include "tests/scenarios/small_town.h"

namespace noonmark::tests {
namespace {

using testing::HasSubstr;

// A plate of 20 x 20 m in the middle of the lot.
const Footprint lot = box(0, 0, 60, 60);

MassingSettings tower(int storeys, WallShape walls) {
    return {.storeyHeightM = 4, .storeys = storeys, .plate = {.areaM2 = 400}, .walls = walls};
}

double volumeOf(const Building& building) {
    double volume = 0;
    for (const Part& part : building.parts) {
        const TriangleMesh mesh = meshOf(part);
        EXPECT_EQ(findOpenEdges(mesh), 0U);
        volume += signedVolume(mesh);
    }
    return volume;
}

TEST(LeaningWalls, ATaperIsAFrustum) {
    const Massing massing = makeMassing(lot, tower(10, {.taper = 0.5})).value();
    // Storey i has its floor at i / 10 of the height, where the sides are 20 x (1 - i / 20) m.
    double floors = 0;
    for (int i = 0; i < 10; ++i) floors += 400 * (1 - i / 20.0) * (1 - i / 20.0);
    EXPECT_NEAR(massing.figures.grossFloorM2, floors, 0.5);
    EXPECT_NEAR(area(topPlateOf(massing.tiers[0])), 100, 0.1);
    const Building built = buildingOf(massing, "taper").value();
    ASSERT_EQ(built.parts.size(), 1U);
    ASSERT_TRUE(built.parts[0].mesh);
    EXPECT_FALSE(built.parts[0].isOverhanging);
    EXPECT_EQ(built.parts[0].heightSource, HeightSource::designed);
    EXPECT_EQ(built.parts[0].mesh->triangles.size(), 12U) << "no levels between bottom and top";
    EXPECT_NEAR(volumeOf(built), 40.0 / 3 * (400 + 200 + 100), 5);
}

TEST(LeaningWalls, TheFiguresAreTheSectionsOfTheMesh) {
    const Massing massing = makeMassing(lot, tower(12, {.taper = 0.4, .twistDeg = 60})).value();
    const Building built = buildingOf(massing, "both").value();
    const FloorArea measured = computeFloorArea(built, 0, 4);
    EXPECT_EQ(measured.storeys, 12);
    EXPECT_EQ(measured.estimatedStoreys, 0);
    EXPECT_NEAR(measured.grossM2, massing.figures.grossFloorM2, 0.002 * measured.grossM2);
}

TEST(LeaningWalls, ATwistTurnsEachFloorClockwise) {
    const Massing massing = makeMassing(lot, tower(10, {.twistDeg = 45})).value();
    EXPECT_NEAR(massing.figures.grossFloorM2, 4000, 1);
    const Building built = buildingOf(massing, "twist").value();
    // Turned by 45 degrees, the square's corners lie on the axes, 10 x sqrt(2) m from the middle.
    float east = 0, north = 0;
    for (const glm::vec3 point : built.parts[0].mesh->vertices)
        if (point.z == 40) {
            east = std::max(east, point.x);
            if (point.x > 40) north = point.y;
        }
    EXPECT_NEAR(east, 30 + 10 * std::sqrt(2.0), 0.01);
    EXPECT_NEAR(north, 30, 0.05);
    // Half way up it is turned by 22.5 degrees: the north-east corner has gone clockwise, to 22.5 degrees
    // from the east.
    bool found = false;
    const double turned = 22.5 * std::numbers::pi / 180, radius = 10 * std::sqrt(2.0);
    const glm::dvec2 corner{30 + radius * std::cos(turned), 30 + radius * std::sin(turned)};
    const Plate half = plateAt(massing.tiers[0], 20);
    for (const glm::vec2 point : half[0].outer)
        found = found || glm::distance(glm::dvec2(point), corner) < 0.05;
    EXPECT_TRUE(found);
    EXPECT_NEAR(volumeOf(built), 16000, 80);
    EXPECT_GT(area(built.parts[0].footprint), 450) << "the outline contains all floors";
}

// The outline is computed faster by sections that are known to lie within it; they must not change it.
TEST(LeaningWalls, TheOutlineOfATwistIsThatOfItsTriangles) {
    for (const WallShape walls : {WallShape{.twistDeg = 20}, WallShape{.taper = 0.4, .twistDeg = -35},
                                  WallShape{.taper = 0.9, .twistDeg = 60}}) {
        const Building built = buildingOf(makeMassing(lot, tower(6, walls)).value(), "twist").value();
        const Part& part = built.parts.at(0);
        const auto whole = computeOutline(*part.mesh, true).pieces;
        ASSERT_EQ(whole.size(), 1U);
        EXPECT_NEAR(area(part.footprint), area(whole[0]), 0.05);
        EXPECT_LT(computeAreaOutside(whole[0], {part.footprint}), 0.05);
    }
}

TEST(LeaningWalls, LevelsAreFloorsAndNoStepTurnsFar) {
    Tier tier{.plate = {box(0, 0, 20, 20)}, .bottomM = 8, .topM = 28, .walls = {.twistDeg = 30}};
    const std::vector<double> levels = levelsOf(tier, 4);
    for (const double floor : {8.0, 12.0, 16.0, 20.0, 24.0, 28.0})
        EXPECT_THAT(levels, testing::Contains(testing::DoubleNear(floor, 1e-9)));
    for (std::size_t i = 1; i < levels.size(); ++i)
        EXPECT_LE((levels[i] - levels[i - 1]) / 20 * 30, maxTurnBetweenLevelsDeg + 1e-9);
    tier.walls = {.taper = 0.3};
    EXPECT_EQ(levelsOf(tier, 4), (std::vector<double>{8, 28}));
}

TEST(LeaningWalls, CourtyardsTurnToo) {
    Footprint court = box(0, 0, 60, 60);
    court.holes.push_back({{20, 20}, {20, 40}, {40, 40}, {40, 20}});
    const Massing massing =
        makeMassing(court, {.storeys = 6, .plate = {.shareOfLot = 0.5}, .walls = {.twistDeg = 10}}).value();
    const Building built = buildingOf(massing, "court").value();
    EXPECT_NEAR(volumeOf(built), 6 * 3.5 * 0.5 * 3200, 200);
    EXPECT_NEAR(massing.figures.grossFloorM2, 6 * 0.5 * 3200, 5);
}

TEST(LeaningWalls, VolumesStandOnTheTopOfTheOneBelow) {
    MassingSettings settings = tower(20, {.taper = 0.2});
    settings.podium = Podium{.storeys = 4, .plate = {.areaM2 = 1600}, .walls = {.taper = 0.25}};
    settings.setbacks = {{.aboveM = 48, .insetM = 2, .walls = {.taper = 0.5, .twistDeg = 30}}};
    const Massing massing = makeMassing(lot, settings).value();
    ASSERT_EQ(massing.tiers.size(), 3U);
    EXPECT_NEAR(area(topPlateOf(massing.tiers[0])), 900, 0.5);
    EXPECT_NEAR(massing.tiers[2].areaM2, 12 * 12, 0.1) << "20 m, tapered to 16 m, less 2 m on both sides";
    EXPECT_NEAR(area(topPlateOf(massing.tiers[2])), 36, 0.1);
    EXPECT_TRUE(buildingOf(massing, "three"));
    settings.podium->walls.taper = 0.75;
    EXPECT_THAT(makeMassing(lot, settings).error().text(), HasSubstr("beyond its podium"));
}

// A twisted volume is an overhang to the engines, but the tower stands on it.
TEST(LeaningWalls, ATowerIsMeasuredFromItsTwistedLowestVolume) {
    MassingSettings settings = tower(40, {.twistDeg = 30});
    settings.setbacks = {{.aboveM = 80, .insetM = 2}};
    const Massing massing = makeMassing(lot, settings).value();
    const Building built = buildingOf(massing, "twisted").value();
    ASSERT_EQ(built.parts.size(), 2U);
    ASSERT_TRUE(built.parts[0].isOverhanging);
    City city;
    city.buildings = {std::make_shared<const Building>(built)};
    EXPECT_NEAR(heightM(built, city), 160, 1e-3);
    const FloorArea floors = computeFloorArea(built, double(findGroundUnder(built, city)), 4);
    EXPECT_EQ(floors.storeys, 40);
    EXPECT_NEAR(floors.grossM2, 20 * 400 + 20 * 256, 10);
    EXPECT_NEAR(floors.grossM2, massing.figures.grossFloorM2, 10);
    double outlineM2 = 0;
    for (const Footprint& piece : computeOutline(built)) outlineM2 += area(piece);
    EXPECT_GT(outlineM2, 400) << "of the turning plates, not of the plate above the setback";
}

TEST(LeaningWalls, WhatCannotBeIsRefusedWithTheLimit) {
    const auto refusal = [](WallShape walls, double shareOfLot = 0.2) {
        const auto made =
            makeMassing(lot, {.storeys = 10, .plate = {.shareOfLot = shareOfLot}, .walls = walls});
        return made ? std::string() : made.error().text();
    };
    EXPECT_THAT(refusal({.taper = 1}), HasSubstr("0 to 95 %"));
    EXPECT_THAT(refusal({.taper = -0.1}), HasSubstr("0 to 95 %"));
    EXPECT_THAT(refusal({.taper = std::nan("")}), HasSubstr("0 to 95 %"));
    EXPECT_THAT(refusal({.twistDeg = 400}), HasSubstr("-360 to 360"));
    EXPECT_THAT(refusal({.twistDeg = 90}, 0.9), HasSubstr("leaves the lot")) << "half way round";
    EXPECT_EQ(refusal({.twistDeg = 360}), "");
}

// The ray reference, which traces triangles, against the engines that use walls and polygons.
TEST(LeaningWalls, AllEnginesSeeThem) {
    const auto shadowAreaOf = [](WallShape walls, const char* engine) {
        City city;
        city.frame = Frame({-73.97, 40.76});
        const Massing massing = makeMassing(lot, tower(30, walls)).value();
        city.buildings.push_back(shared(buildingOf(massing, "tower").value()));
        StudySettings settings{.region = {"around", {box(-150, -50, 200, 250)}}, .engine = engine};
        settings.receivers.cellM = 2;
        settings.period.start = std::chrono::year(2026) / 4 / 20;
        settings.period.stepMinutes = 10;
        settings.period.zone = "America/New_York";
        NoProgress progress;
        return runStudy(city, settings, progress, {}).value().statistics.shadowAreaM2;
    };
    const WallShape leaning{.taper = 0.4, .twistDeg = 80};
    const double traced = shadowAreaOf(leaning, "ray");
    EXPECT_NEAR(shadowAreaOf(leaning, "projected"), traced, 0.002 * traced);
    EXPECT_NEAR(shadowAreaOf(leaning, "horizon"), traced, 0.002 * traced);
    EXPECT_LT(traced, 0.9 * shadowAreaOf({}, "ray")) << "less than that of the upright tower";
}

}  // namespace
}  // namespace noonmark::tests
