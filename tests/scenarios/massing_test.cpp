#include "scenarios/massing/massing.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/city/city.h"
#include "core/city/meshes/mesh_topology.h"
#include "scenarios/massing/copy_massing.h"
#include "scenarios/massing/floor_plate.h"
#include "scenarios/massing/straight_skeleton.h"
#include "tests/core/city/hostile_polygons.h"
#include "tests/scenarios/small_town.h"

namespace noonmark::tests {
namespace {

using testing::AllOf;
using testing::HasSubstr;

Footprint withCourtyard() {
    Footprint lot = box(0, 0, 60, 40);
    lot.holes.push_back({{20, 10}, {20, 30}, {40, 30}, {40, 10}});
    return lot;
}

Footprint lShape() { return {{{0, 0}, {40, 0}, {40, 15}, {15, 15}, {15, 40}, {0, 40}}, {}}; }

std::string refusal(const Footprint& lot, const MassingSettings& settings) {
    const auto massing = makeMassing(lot, settings);
    return massing ? "" : massing.error().text();
}

double computeVolume(const Building& building) {
    double volume = 0;
    for (const Part& part : building.parts) {
        const TriangleMesh mesh = meshOf(part);
        EXPECT_EQ(findOpenEdges(mesh), 0U);
        EXPECT_GT(signedVolume(mesh), 0);
        volume += signedVolume(mesh);
    }
    return volume;
}

TEST(StraightSkeleton, InsetsARectangleByHand) {
    const auto skeleton = StraightSkeleton::of(box(0, 0, 40, 20)).value();
    EXPECT_NEAR(skeleton.deepestM(), 10, 1e-9);
    const auto inset = skeleton.inset(3);
    ASSERT_EQ(inset.size(), 1U);
    EXPECT_EQ(bounds(inset[0]), (Box2{{3, 3}, {37, 17}}));
    EXPECT_TRUE(skeleton.inset(10).empty());
    EXPECT_EQ(skeleton.inset(0), std::vector<Footprint>{box(0, 0, 40, 20)});
}

TEST(StraightSkeleton, CourtyardsGrow) {
    const auto inset = StraightSkeleton::of(withCourtyard()).value().inset(2);
    ASSERT_EQ(inset.size(), 1U);
    ASSERT_EQ(inset[0].holes.size(), 1U);
    EXPECT_NEAR(area(inset[0]), 56 * 36 - 24 * 24, 1e-3);
}

TEST(StraightSkeleton, AWaistParts) {
    // Two squares of 20 m connected by a neck 4 m wide.
    const Footprint dumbbell{{{0, 0},
                              {20, 0},
                              {20, 8},
                              {40, 8},
                              {40, 0},
                              {60, 0},
                              {60, 20},
                              {40, 20},
                              {40, 12},
                              {20, 12},
                              {20, 20},
                              {0, 20}},
                             {}};
    EXPECT_EQ(StraightSkeleton::of(dumbbell).value().inset(1).size(), 1U);
    EXPECT_EQ(StraightSkeleton::of(dumbbell).value().inset(3).size(), 2U);
}

TEST(StraightSkeleton, WhatCrossesItselfIsRefused) {
    EXPECT_FALSE(StraightSkeleton::of({{{0, 0}, {10, 10}, {10, 0}, {0, 10}}, {}}));
    EXPECT_FALSE(StraightSkeleton::of({{{0, 0}, {10, 10}}, {}}));
    Footprint touching = box(0, 0, 20, 20);
    touching.holes.push_back({{0, 10}, {5, 12}, {5, 8}});
    EXPECT_FALSE(StraightSkeleton::of(touching));
    touching.holes = {{{30, 10}, {35, 12}, {35, 8}}};
    EXPECT_FALSE(StraightSkeleton::of(touching));
}

TEST(Massing, StatesItsFigures) {
    const Massing massing = makeMassing(box(0, 0, 40, 25), {.storeyHeightM = 3.5, .storeys = 20}).value();
    EXPECT_NEAR(massing.figures.lotM2, 1000, 1e-6);
    EXPECT_NEAR(massing.figures.grossFloorM2, 20000, 1e-3);
    EXPECT_NEAR(massing.figures.floorAreaRatio, 20, 1e-6);
    EXPECT_NEAR(massing.figures.coverage, 1, 1e-6);
    EXPECT_EQ(massing.figures.heightM, 70);
    EXPECT_EQ(massing.figures.storeys, 20);
    const Building tower = buildingOf(massing, "tower").value();
    EXPECT_NEAR(computeVolume(tower), 70000, 1);
    for (const Part& part : tower.parts) EXPECT_EQ(part.heightSource, HeightSource::designed);
}

TEST(Massing, ATotalHeightGivesWholeStoreys) {
    const Massing massing = makeMassing(box(0, 0, 40, 25), {.storeyHeightM = 4, .heightM = 30}).value();
    EXPECT_EQ(massing.figures.storeys, 7);
    EXPECT_EQ(massing.figures.heightM, 30);
    EXPECT_NEAR(massing.figures.grossFloorM2, 7000, 1e-3);
}

TEST(Massing, PodiumTowerAndSetbacks) {
    MassingSettings settings{.storeyHeightM = 4, .storeys = 30, .plate = {.shareOfLot = 0.5}};
    settings.podium = Podium{.storeys = 5, .plate = {.areaM2 = 900}};
    settings.setbacks = {{.aboveM = 60, .insetM = 2}, {.aboveM = 100, .insetM = 3}};
    const Massing massing = makeMassing(box(0, 0, 40, 25), settings).value();
    ASSERT_EQ(massing.tiers.size(), 4U);
    EXPECT_NEAR(massing.tiers[0].areaM2, 900, 0.1);
    EXPECT_NEAR(massing.tiers[1].areaM2, 500, 0.1);
    // The plate of half the lot is the lot's inset by x: (40 - 2x)(25 - 2x) = 500.
    const double x = (65 - std::sqrt(65.0 * 65 - 4 * 500)) / 4;
    EXPECT_NEAR(massing.tiers[2].areaM2, (40 - 2 * x - 4) * (25 - 2 * x - 4), 0.1);
    EXPECT_NEAR(massing.tiers[3].areaM2, (40 - 2 * x - 10) * (25 - 2 * x - 10), 0.1);
    EXPECT_EQ(massing.tiers[0].storeys, 5);
    EXPECT_EQ(massing.tiers[1].storeys, 10);
    EXPECT_EQ(massing.tiers[2].storeys, 10);
    EXPECT_EQ(massing.tiers[3].storeys, 5);
    EXPECT_NEAR(massing.figures.coverage, 0.9, 1e-4);
    const double floors = 900 * 5 + 500 * 10 + massing.tiers[2].areaM2 * 10 + massing.tiers[3].areaM2 * 5;
    EXPECT_NEAR(massing.figures.grossFloorM2, floors, 1);
    EXPECT_NEAR(computeVolume(buildingOf(massing, "tower").value()), floors * 4, 10);
}

TEST(Massing, CourtyardsAreKept) {
    const Massing massing =
        makeMassing(withCourtyard(), {.storeys = 6, .plate = {.shareOfLot = 0.7}}).value();
    ASSERT_EQ(massing.tiers[0].plate[0].holes.size(), 1U);
    EXPECT_NEAR(massing.figures.grossFloorM2, 6 * 0.7 * 2000, 1);
    EXPECT_NEAR(computeVolume(buildingOf(massing, "court").value()), 6 * 3.5 * 1400, 5);
}

TEST(Massing, ATowerIsTurnedOnItsLot) {
    const Massing massing =
        makeMassing(box(0, 0, 40, 40), {.storeys = 10, .plate = {.shareOfLot = 0.25}, .clockwiseDeg = 45})
            .value();
    const Box2 across = bounds(massing.tiers[0].plate[0]);
    EXPECT_NEAR(across.high.x - across.low.x, 20 * std::sqrt(2.0), 1e-2);
    EXPECT_NEAR(massing.figures.grossFloorM2, 4000, 1);
}

TEST(Massing, WhatCannotExistIsRefusedWithTheLimit) {
    const Footprint lot = box(0, 0, 40, 20);
    EXPECT_THAT(refusal(lot, {}), HasSubstr("either storeys or a total height"));
    EXPECT_THAT(refusal(lot, {.storeys = 5, .heightM = 20}), HasSubstr("given twice"));
    EXPECT_THAT(refusal(lot, {.heightM = -20}), HasSubstr("0 to 2000 m"));
    EXPECT_THAT(refusal(lot, {.storeys = -1}), HasSubstr("0 to 500"));
    EXPECT_THAT(refusal(lot, {.storeyHeightM = 1, .storeys = 5}), HasSubstr("2 to 10"));
    EXPECT_THAT(refusal(lot, {.heightM = std::nan("")}), HasSubstr("2000"));
    EXPECT_THAT(refusal(lot, {.storeys = 5, .plate = {.areaM2 = 900}}),
                AllOf(HasSubstr("900 m2 does not fit"), HasSubstr("800 m2")));
    EXPECT_THAT(refusal(lot, {.storeys = 5, .plate = {.shareOfLot = 1.2}}), HasSubstr("0 to 100 %"));
    EXPECT_THAT(refusal(lot, {.storeys = 30, .setbacks = {{50, 12}}}),
                AllOf(HasSubstr("leaves nothing"), HasSubstr("less than 10.0 m")));
    EXPECT_THAT(refusal(lot, {.storeys = 10, .setbacks = {{50, 2}}}), HasSubstr("between 0 and 35 m"));
    EXPECT_THAT(refusal(lot, {.storeys = 10, .plate = {.shareOfLot = 0.9}, .clockwiseDeg = 90}),
                AllOf(HasSubstr("leaves the lot"), HasSubstr("% of the lot")));
    MassingSettings podium{.storeys = 3, .podium = Podium{.storeys = 3}};
    EXPECT_THAT(refusal(lot, podium), HasSubstr("not lower than the whole"));
    podium = {.storeys = 9, .podium = Podium{.storeys = 3, .plate = {.shareOfLot = 0.5}}};
    EXPECT_THAT(refusal(lot, podium), HasSubstr("extends beyond its podium"));
    EXPECT_THAT(refusal(box(0, 0, 2, 2), {.storeys = 5}), HasSubstr("too small"));
}

TEST(Massing, HostileLotsGiveClosedSolidsOrAWarning) {
    for (const Footprint& lot : {lShape(), withCourtyard()})
        for (const double share : {0.05, 0.3, 0.6, 0.95, 1.0}) {
            const auto massing = makeMassing(lot, {.storeys = 12, .plate = {.shareOfLot = share}});
            ASSERT_TRUE(massing) << massing.error().text();
            EXPECT_NEAR(massing->figures.grossFloorM2, 12 * share * area(lot), 0.002 * 12 * area(lot));
            EXPECT_TRUE(liesOn(massing->tiers[0].plate, {lot}));
            EXPECT_TRUE(buildingOf(*massing, "x"));
        }
}

TEST(Massing, EveryHostileOutlineGivesClosedSolidsOrAWarning) {
    const auto polygons = hostilePolygons();
    if (polygons.empty()) GTEST_SKIP() << "the shared data are not here";
    int built = 0;
    for (const HostilePolygon& polygon : polygons)
        for (const Footprint& lot : repairFootprint(polygon.rings).pieces) {
            const auto massing = makeMassing(lot, {.storeys = 12, .plate = {.shareOfLot = 0.5}});
            if (!massing) {
                EXPECT_FALSE(massing.error().advice.empty()) << polygon.name;
                continue;
            }
            EXPECT_NEAR(massing->figures.grossFloorM2, 6 * area(lot), 0.01 * area(lot)) << polygon.name;
            EXPECT_TRUE(buildingOf(*massing, polygon.name)) << polygon.name;
            ++built;
        }
    EXPECT_GT(built, 40);
}

TEST(SameFloorArea, TheDoublePlateIsHalfAsHigh) {
    const Footprint lot = box(0, 0, 60, 60);
    const PreservedFloorArea given = massOf(house("t", box(20, 20, 40, 40), 350), 0, 3.5).value();
    EXPECT_NEAR(given.grossFloorM2, 40000, 1e-3);
    const Massing wide = findSameFloorArea(lot, given, 2).value();
    EXPECT_EQ(wide.figures.storeys, 50);
    EXPECT_NEAR(wide.figures.grossFloorM2, 40000, 20);
    EXPECT_NEAR(wide.figures.heightM, 175, 1e-9);
    EXPECT_TRUE(buildingOf(wide, "wide"));
}

// Tapers from 40 x 40 m to 10 x 10 m at 30 m, 3 m per storey: sides 40, 37, ... 13, in total 7,765 m2 rather
// than 10 x 1600.
TEST(SameFloorArea, ATaperHasItsOwnFloors) {
    TriangleMesh mesh;
    for (const auto& [half, z] : {std::pair{20.0F, 0.0F}, {5.0F, 30.0F}})
        for (const glm::vec2 c : {glm::vec2(-1, -1), {1, -1}, {1, 1}, {-1, 1}})
            mesh.vertices.emplace_back(c * half, z);
    mesh.triangles = {{0, 2, 1}, {0, 3, 2}, {4, 5, 6}, {4, 6, 7}};
    for (std::uint32_t i = 0; i < 4; ++i)
        mesh.triangles.insert(mesh.triangles.end(),
                              {{i, (i + 1) % 4, 4 + (i + 1) % 4}, {i, 4 + (i + 1) % 4, 4 + i}});
    ASSERT_EQ(findOpenEdges(mesh), 0U);
    Building taper{.sourceId = "taper"};
    taper.parts.push_back({.footprint = box(-20, -20, 20, 20), .topM = 30});
    taper.parts[0].mesh = std::make_shared<const TriangleMesh>(mesh);
    double expected = 0;
    for (int side = 40; side > 10; side -= 3) expected += (side - 0.01) * (side - 0.01);
    const PreservedFloorArea given = massOf(taper, 0, 3).value();
    EXPECT_NEAR(given.grossFloorM2, expected, 0.5);
    EXPECT_NEAR(given.grossFloorM2, 7765, 6);
    EXPECT_NEAR(area(given.plate), 39.99 * 39.99, 0.1);
}

// A lot of 90 x 30 m in three pieces of 22 m with gaps of 12 m: 22 x 30 = 660 m2 each.
TEST(SeveralTowers, StandApartOnTheirPiecesOfTheLot) {
    const Footprint lot = box(0, 0, 90, 30);
    MassingSettings settings{.storeyHeightM = 4, .storeys = 20};
    settings.further = {{10, {}}, {5, {.areaM2 = 200}}};
    const Massing massing = makeMassing(lot, settings).value();
    ASSERT_EQ(massing.tiers.size(), 3U);
    EXPECT_EQ(massing.firstTiers, 1U);
    EXPECT_EQ(bounds(massing.tiers[0].plate[0]), (Box2{{0, 0}, {22, 30}}));
    EXPECT_EQ(bounds(massing.tiers[1].plate[0]), (Box2{{34, 0}, {56, 30}}));
    EXPECT_NEAR(massing.tiers[2].areaM2, 200, 0.2);
    const MassingFigures& figures = massing.figures;
    EXPECT_NEAR(figures.grossFloorM2, 660 * 20 + 660 * 10 + 200 * 5, 1);
    EXPECT_NEAR(figures.floorAreaRatio, figures.grossFloorM2 / 2700, 1e-9);
    EXPECT_NEAR(figures.coverage, (660 + 660 + 200) / 2700.0, 1e-3);
    EXPECT_EQ(figures.heightM, 80);
    EXPECT_EQ(figures.storeys, 20);
    EXPECT_NEAR(massing.storeyM2[4], 1520, 0.5);
    EXPECT_NEAR(massing.storeyM2[5], 1320, 0.5);
    const Building building = buildingOf(massing, "pair").value();
    EXPECT_EQ(building.parts.size(), 3U) << "one building, and so one edit";
    EXPECT_NEAR(computeVolume(building), figures.grossFloorM2 * 4, 10);
}

TEST(SeveralTowers, CountFloorsWithoutAUseApart) {
    MassingSettings settings{.storeyHeightM = 4, .storeys = 10, .uses = {{"homes", 0}}};
    settings.further = {{5, {}}};
    const auto uses = makeMassing(box(0, 0, 72, 30), settings).value().figures.uses;  // 2 x 30 x 30 m
    ASSERT_EQ(uses.size(), 2U);
    EXPECT_NEAR(uses[0].grossFloorM2, 9000, 1);
    EXPECT_EQ(uses[1].use, "");
    EXPECT_NEAR(uses[1].grossFloorM2, 4500, 1);
}

TEST(SeveralTowers, NeedRoom) {
    MassingSettings settings{.storeys = 10};
    settings.further = {{5, {}}, {5, {}}};
    EXPECT_THAT(refusal(box(0, 0, 24, 10), settings), HasSubstr("too small for 3 towers 12 m apart"));
    settings.gapM = 3;
    EXPECT_EQ(refusal(box(0, 0, 24, 10), settings), "");
    settings.further[1].plate.areaM2 = 100;  // its piece has 6 x 10 m2
    EXPECT_THAT(refusal(box(0, 0, 24, 10), settings), HasSubstr("Tower 3 of 3"));
    settings.further[1].storeys = 0;
    EXPECT_NE(refusal(box(0, 0, 24, 10), settings), "");
}

TEST(SameFloorArea, WhereTheLotIsTooSmallThePlateIsTheLot) {
    const Footprint lot = box(18, 0, 42, 60);  // 1440 m2; the building's plate is 20 x 20 m
    const PreservedFloorArea given = massOf(house("t", box(20, 20, 40, 40), 350), 0, 3.5).value();
    const Massing widest = findSameFloorArea(lot, given, largestPlate).value();
    EXPECT_EQ(widest.figures.storeys, 28);  // 40000 / 1440 = 27.8
    EXPECT_NEAR(widest.figures.grossFloorM2, 40000, 20);
    EXPECT_TRUE(liesOn(widest.tiers[0].plate, {lot}));
    const Massing five = findSameFloorArea(lot, given, 5).value();
    EXPECT_EQ(five.figures.storeys, 28);
}

TEST(SameFloorArea, SlimmerIsTaller) {
    const Footprint lot = box(0, 0, 60, 60);
    const PreservedFloorArea given =
        massOf(makeMassing(lot, {.storeys = 40, .plate = {.shareOfLot = 0.5}}).value());
    const Massing slim = findSameFloorArea(lot, given, 0.5).value();
    EXPECT_EQ(slim.figures.storeys, 80);
    EXPECT_NEAR(slim.figures.grossFloorM2, given.grossFloorM2, 0.001 * given.grossFloorM2);
    EXPECT_THAT(findSameFloorArea(lot, given, 0.01).error().text(), HasSubstr("or more: 500 storeys"));
    EXPECT_FALSE(findSameFloorArea(lot, given, 0));
    EXPECT_THAT(findSameFloorArea(box(100, 0, 160, 60), given, 2).error().text(),
                HasSubstr("does not stand on the lot"));
}

}  // namespace
}  // namespace noonmark::tests
