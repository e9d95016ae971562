#include <gtest/gtest.h>
#include <cmath>
#include <random>

#include "core/city/meshes/mesh_outline.h"
#include "core/city/meshes/mesh_parts.h"
#include "core/city/meshes/mesh_topology.h"
#include "core/io/read_city.h"
#include "tests/core/city/mesh_fixtures.h"
#include "tests/core/engines/eaves_scenes.h"
#include "tests/core/io/cityjson_fixtures.h"
#include "tests/shared/shared_data.h"

namespace noonmark {

namespace {

using namespace tests;

std::vector<Part> partsOfHouse(const EavesHouse& house) {
    return cityOf(std::vector{house}).buildings[0]->parts;
}

TEST(Eaves, BecomeAPartOfTheirOwn) {
    const std::vector<Part> parts = partsOfHouse({});
    ASSERT_EQ(parts.size(), 2U);
    EXPECT_FALSE(parts[0].isOverhanging);
    EXPECT_NEAR(area(parts[0].footprint), 80, 0.1) << "what the walls enclose";
    EXPECT_EQ(parts[0].bottomM, 0);
    EXPECT_EQ(parts[0].topM, 7);
    EXPECT_TRUE(parts[1].isOverhanging);
    EXPECT_NEAR(area(parts[1].footprint), 12 * 10 - 80, 0.4);
    EXPECT_EQ(parts[1].bottomM, 4.5F);
}

// Where roof and walls share the points of the gables, they are one component.
TEST(Eaves, OfAShellWhoseRoofSharesPointsWithItsWallsAreFound) {
    TriangleMesh mesh = meshOf(EavesHouse{});
    // Two more triangles join the ridge of the southern sheet to the tops of the gables.
    const auto at = std::uint32_t(mesh.vertices.size());
    mesh.vertices.insert(mesh.vertices.end(), {{-1, 4, 7}, {0, 4, 7}, {-1, 3, 6.5F}});
    mesh.triangles.emplace_back(at, at + 2, at + 1);
    const MeshParts made = partsOf(mesh, "", "");
    ASSERT_EQ(made.parts.size(), 2U);
    EXPECT_FALSE(made.parts[0].isOverhanging);
    EXPECT_TRUE(made.parts[1].isOverhanging);
}

TEST(Eaves, OfAFlatRoofAreASlab) {
    const std::vector<Part> parts = partsOfHouse({.slope = 0});
    ASSERT_EQ(parts.size(), 2U);
    EXPECT_FALSE(parts[1].mesh);
    EXPECT_TRUE(parts[1].isOverhanging);
    EXPECT_EQ(parts[1].topM, 5);
    EXPECT_NEAR(area(parts[1].footprint), 40, 0.4);
}

TEST(Eaves, AHouseWithoutThemStaysAsItIs) {
    for (const double overhangM : {0.0, 0.05}) {
        const EavesHouse house{.overhangM = overhangM};
        EXPECT_FALSE(cutEaves(weld(meshOf(house)))) << overhangM;
        EXPECT_EQ(partsOfHouse(house).size(), 1U) << overhangM;
    }
}

TEST(Eaves, ThatNearlyTouchTheGroundStaySolid) {
    EXPECT_EQ(partsOfHouse({.wallM = 1.5, .slope = 0.05}).size(), 1U);
}

TEST(Eaves, NoPieceOfTheRoofIsLost) {
    for (const EavesHouse& house : village()) {
        const TriangleMesh whole = weld(meshOf(house));
        const auto cut = cutEaves(whole);
        ASSERT_TRUE(cut);
        // Body and eaves overlap by 1 cm along the walls; upright faces count nothing.
        const double around = 2 * (house.lengthM + house.depthM);
        double plan = 0, pieces = 0;
        for (const glm::uvec3 t : whole.triangles)
            plan += std::abs(signedArea({glm::vec2(whole.vertices[t.x]), glm::vec2(whole.vertices[t.y]),
                                         glm::vec2(whole.vertices[t.z])}));
        for (const TriangleMesh* mesh : {&cut->body, &cut->eaves})
            for (const glm::uvec3 t : mesh->triangles)
                pieces += std::abs(signedArea({glm::vec2(mesh->vertices[t.x]), glm::vec2(mesh->vertices[t.y]),
                                               glm::vec2(mesh->vertices[t.z])}));
        EXPECT_NEAR(pieces, plan + 0.01 * around, 0.002 * around + 0.01);
    }
}

Json cityJsonOf(const std::vector<EavesHouse>& houses) {
    CityJsonMaker maker;
    for (std::size_t i = 0; i < houses.size(); ++i) {
        Json faces = Json::array();
        for (const auto& surface : surfacesOf(houses[i])) {
            Json ring = Json::array();
            for (const glm::dvec3 corner : surface) ring.push_back(maker.addVertex(corner));
            faces.push_back(Json::array({ring}));
        }
        maker.addBuilding("house " + std::to_string(i),
                          {{"type", "MultiSurface"}, {"lod", "2"}, {"boundaries", faces}});
    }
    return maker.document();
}

TEST(Eaves, AreReadFromCityJson) {
    const TemporaryFolder folder;
    NoProgress progress;
    const std::vector<EavesHouse> houses = village();
    const auto read =
        readCity({folder.file("village.city.json", cityJsonOf(houses).dump())}, {}, progress, {});
    ASSERT_TRUE(read) << read.error().text();
    ASSERT_EQ(read->city.buildings.size(), houses.size());
    for (const auto& building : read->city.buildings) {
        const EavesHouse& house = houses[std::stoul(building->sourceId.substr(6))];
        const std::vector<Part>& parts = building->parts;
        ASSERT_GE(parts.size(), 2U) << building->sourceId;
        EXPECT_FALSE(parts[0].isOverhanging) << building->sourceId;
        EXPECT_NEAR(area(parts[0].footprint), house.lengthM * house.depthM, 0.2) << building->sourceId;
        for (std::size_t part = 1; part < parts.size(); ++part) EXPECT_TRUE(parts[part].isOverhanging);
    }
}

// A house in a row without its party walls, and with a shed whose walls are complete: the shed's walls alone
// enclose an area, yet the roof of the building is no eaves.
TEST(Eaves, AHouseWhosePartyWallsAreMissingIsNone) {
    TriangleMesh mesh = tests::box({0, 0, 0}, {3, 3, 2.5F});
    const auto at = std::uint32_t(mesh.vertices.size());
    mesh.vertices.insert(
        mesh.vertices.end(),
        {{0, 3, 0}, {3, 3, 0}, {3, 3, 6}, {0, 3, 6}, {0, 5.5F, 0}, {3, 5.5F, 0}, {3, 5.5F, 6}, {0, 5.5F, 6}});
    for (const glm::uvec3 t : {glm::uvec3{0, 1, 2}, {0, 2, 3}, {5, 4, 7}, {5, 7, 6}, {3, 2, 6}, {3, 6, 7}})
        mesh.triangles.push_back(t + at);
    EXPECT_FALSE(cutEaves(weld(mesh)));
}

TEST(Eaves, ARoofFarBeyondTheWallsIsNone) {
    EXPECT_TRUE(cutEaves(weld(meshOf(EavesHouse{.overhangM = 2.5}))));
    EXPECT_FALSE(cutEaves(weld(meshOf(EavesHouse{.wallM = 8, .overhangM = 4}))));
}

// 807 of the 853 shells are open, many without party walls; none of their roofs overhangs.
TEST(Eaves, ACityWithoutThemKeepsItsParts) {
    const auto file = sharedData("delfshaven/3-20-DELFSHAVEN.city.json");
    if (!file) GTEST_SKIP() << "no shared data";
    NoProgress progress;
    const City city = readCity({*file}, {}, progress, {}).value().city;
    for (const auto& building : city.buildings) EXPECT_EQ(building->parts.size(), 1U) << building->sourceId;
}

using tests::box;

float flatGround(glm::dvec2) { return 0; }

bool warns(const Warnings& warnings, const std::string& what) {
    return std::any_of(warnings.begin(), warnings.end(),
                       [&](const Warning& w) { return w.what.find(what) != w.what.npos; });
}

TEST(MeshOutline, OfABoxIsItsBaseWithFourCorners) {
    const MeshOutline outline = computeOutline(box({1, 2, 3}, {11, 22, 33}), true);
    ASSERT_EQ(outline.pieces.size(), 1U);
    EXPECT_EQ(outline.pieces[0].outer.size(), 4U);
    EXPECT_NEAR(signedArea(outline.pieces[0].outer), 200, 1e-6);
    EXPECT_FALSE(outline.wallsOnly);
}

TEST(MeshOutline, FarFromTheOriginStaysSimple) {
    const TriangleMesh mesh = box({29000, -31000, 0}, {29010.1F, -30990.3F, 33});
    const MeshOutline outline = computeOutline(mesh, true);
    ASSERT_EQ(outline.pieces.size(), 1U);
    EXPECT_EQ(outline.pieces[0].outer.size(), 4U);
    EXPECT_NEAR(area(outline.pieces[0]), 10.1 * 9.7, 0.1);
}

// A fan of triangles in float32 far from the origin, where corners fall between millimetres, still has one
// outline.
TEST(MeshOutline, TrianglesThatShareCornersAreNeverParted) {
    std::mt19937 random(11);
    std::uniform_real_distribution<float> place(-4000, 4000), radius(10, 20);
    for (int trial = 0; trial < 500; ++trial) {
        const glm::vec3 at(place(random), place(random), 10);
        TriangleMesh roof{{at}, {}};
        constexpr std::uint32_t corners = 12;
        for (std::uint32_t i = 0; i < corners; ++i) {
            const float angle = 6.2831853F * float(i) / corners;
            roof.vertices.push_back(at + radius(random) * glm::vec3(std::cos(angle), std::sin(angle), 0));
            roof.triangles.emplace_back(0, 1 + i, 1 + (i + 1) % corners);
        }
        const MeshOutline outline = computeOutline(roof, false);
        ASSERT_EQ(outline.pieces.size(), 1U) << trial;
        EXPECT_TRUE(outline.pieces[0].holes.empty());
    }
}

TEST(MeshOutline, AHairlineGapDoesNotPartABuilding) {
    const TriangleMesh halves = tests::joined(box({0, 0, 0}, {5, 10, 10}), box({5.004F, 0, 0}, {10, 10, 10}));
    const MeshOutline outline = computeOutline(halves, true);
    ASSERT_EQ(outline.pieces.size(), 1U);
    EXPECT_NEAR(area(outline.pieces[0]), 100, 0.01);
    EXPECT_EQ(outline.pieces[0].outer.size(), 4U);
    EXPECT_EQ(
        computeOutline(tests::joined(box({0, 0, 0}, {5, 10, 10}), box({5.1F, 0, 0}, {10, 10, 10})), true)
            .pieces.size(),
        2U);
}

// A box without floor and roof.
TriangleMesh wallsOf(glm::vec3 low, glm::vec3 high) {
    TriangleMesh walls = box(low, high);
    walls.triangles.erase(walls.triangles.begin(), walls.triangles.begin() + 4);
    return walls;
}

TEST(MeshOutline, OfWallsAloneIsWhatTheyEnclose) {
    const MeshOutline outline = computeOutline(wallsOf({0, 0, 0}, {10, 10, 10}), false);
    ASSERT_EQ(outline.pieces.size(), 1U);
    EXPECT_TRUE(outline.wallsOnly);
    EXPECT_NEAR(area(outline.pieces[0]), 100, 1e-6);
}

// An L, which a convex hull would fill, and a courtyard in a block of 30 m.
TEST(MeshOutline, WallsAreNoHull) {
    const Ring corners{{0, 0}, {20, 0}, {20, 8}, {8, 8}, {8, 20}, {0, 20}};
    TriangleMesh walls;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const glm::vec2 a = corners[i], b = corners[(i + 1) % corners.size()];
        const auto first = std::uint32_t(walls.vertices.size());
        for (const auto& [at, z] : {std::pair{a, 0.0F}, {b, 0.0F}, {b, 9.0F}, {a, 9.0F}})
            walls.vertices.emplace_back(at, z);
        walls.triangles.insert(walls.triangles.end(),
                               {{first, first + 1, first + 2}, {first, first + 2, first + 3}});
    }
    const MeshOutline outline = computeOutline(walls, false);
    ASSERT_EQ(outline.pieces.size(), 1U);
    EXPECT_NEAR(area(outline.pieces[0]), 20 * 20 - 12 * 12, 1e-4);
    const TriangleMesh block =
        tests::joined(wallsOf({0, 0, 0}, {30, 30, 12}), wallsOf({10, 10, 0}, {20, 20, 12}));
    ASSERT_EQ(computeOutline(block, false).pieces.size(), 1U);
    EXPECT_NEAR(area(computeOutline(block, false).pieces[0]), 800, 1e-4);
}

TEST(MeshOutline, AWallThatStandsOutOfARoofIsInItsBounds) {
    TriangleMesh house = box({0, 0, 0}, {10, 10, 10});
    append(house, {{{10, 5, 0}, {14, 5, 0}, {14, 5, 3}}, {{0, 1, 2}}});
    const MeshOutline outline = computeOutline(house, false);
    ASSERT_EQ(outline.pieces.size(), 1U);
    EXPECT_NEAR(bounds(outline.pieces[0]).high.x, 14, 0.011);
    EXPECT_NEAR(area(outline.pieces[0]), 100, 0.1);
}

TEST(MeshOutline, AWallLineIsNoOverlap) {
    const auto outline = [](glm::vec3 low, glm::vec3 high) {
        return computeOutline(box(low, high), true).pieces;
    };
    const auto groups = groupOverlapping({outline({0, 0, 0}, {10, 10, 10}), outline({10, 0, 0}, {20, 10, 10}),
                                          outline({2, 2, 10}, {8, 8, 20}), outline({7, 7, 20}, {9, 9, 30})});
    EXPECT_EQ(groups, (std::vector<std::size_t>{0, 1, 0, 0}));
}

TEST(MeshParts, ABoxIsOnePart) {
    const MeshParts made = partsOf(tests::unshared(box({0, 0, 1}, {10, 10, 31})), "tower", "file: tower");
    ASSERT_EQ(made.parts.size(), 1U);
    const Part& part = made.parts[0];
    EXPECT_TRUE(made.warnings.empty());
    EXPECT_EQ(part.sourceId, "tower");
    EXPECT_EQ(part.heightSource, HeightSource::mesh);
    EXPECT_EQ(part.bottomM, 1);
    EXPECT_EQ(part.topM, 31);
    EXPECT_FALSE(part.isOverhanging);
    EXPECT_EQ(findOpenEdges(*part.mesh), 0U);
    EXPECT_NEAR(signedVolume(*part.mesh), 3000, 1e-6);
}

TEST(MeshParts, PiecesApartAreParts) {
    const MeshParts made =
        partsOf(tests::joined(box({0, 0, 0}, {1, 1, 5}), box({4, 0, 0}, {6, 2, 9})), "two", "two");
    ASSERT_EQ(made.parts.size(), 2U);
    EXPECT_NEAR(signedVolume(*made.parts[0].mesh) + signedVolume(*made.parts[1].mesh), 5 + 36, 1e-6);
    for (const Part& part : made.parts)
        EXPECT_NEAR(signedVolume(*part.mesh), area(part.footprint) * double(part.topM - part.bottomM), 1e-6);
}

TEST(MeshParts, OverhangIsSeenAndCavityIsNot) {
    const TriangleMesh table = tests::joined(box({4, 4, 0}, {6, 6, 10}), box({0, 0, 10}, {10, 10, 12}));
    EXPECT_TRUE(hasOpenAirBelow(table));
    TriangleMesh cavity = box({2, 2, 3}, {8, 8, 9});
    turnInsideOut(cavity);
    EXPECT_FALSE(hasOpenAirBelow(tests::joined(box({0, 0, 0}, {10, 10, 12}), cavity)));
    EXPECT_FALSE(hasOpenAirBelow(box({0, 0, 50}, {10, 10, 60})));  // markOverhangs handles this case
}

TEST(MeshParts, LeaningWallIsAnOverhang) {
    TriangleMesh funnel = box({0, 0, 0}, {10, 10, 20});
    for (int i = 4; i < 8; ++i) funnel.vertices[std::size_t(i)].x += i % 2 == 0 ? -5.0F : 5.0F;
    EXPECT_TRUE(hasOpenAirBelow(funnel));
}

TEST(MeshParts, ALevelSheetIsASlabOfItsOutline) {
    const TriangleMesh sheet{{{0, 0, 7}, {10, 0, 7}, {10, 10, 7}, {0, 10, 7}}, {{0, 1, 2}, {0, 3, 2}}};
    const MeshParts made = partsOf(sheet, "deck", "");
    ASSERT_EQ(made.parts.size(), 1U);
    const Part& part = made.parts[0];
    EXPECT_TRUE(made.warnings.empty());
    EXPECT_FALSE(part.mesh);
    EXPECT_NEAR(area(part.footprint), 100, 1e-6);
    EXPECT_EQ(part.topM, 7);
    EXPECT_NEAR(part.bottomM, 6.99, 1e-5);
    EXPECT_EQ(part.heightSource, HeightSource::mesh);
}

TEST(MeshParts, AnUprightSheetIsAStrip) {
    const TriangleMesh sheet{{{0, 0, 0}, {1, 0, 0}, {0, 0, 1}}, {{0, 1, 2}}};
    const MeshParts made = partsOf(sheet, "", "");
    ASSERT_EQ(made.parts.size(), 1U);
    EXPECT_TRUE(made.warnings.empty());
    EXPECT_EQ(made.parts[0].topM, 1);
    EXPECT_EQ(made.parts[0].mesh->triangles.size(), 1U);
    // A narrower one would be dropped as a sliver
    EXPECT_NEAR(area(made.parts[0].footprint), 1.01 * 0.02, 1e-5);
    EXPECT_EQ(bounds(made.parts[0].footprint).high.x, 1.005F);
}

TEST(MeshParts, WhatHasNoAreaIsReported) {
    EXPECT_TRUE(partsOf({}, "", "").parts.empty());
    const TriangleMesh line{{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {{0, 1, 2}}};
    EXPECT_TRUE(partsOf(line, "", "").parts.empty());
    EXPECT_TRUE(warns(partsOf(line, "", "").warnings, "no area"));
}

// A roof that faces down and four thin posts: open below, whichever way it faces. Walls along its two long
// sides carry it.
TEST(MeshParts, ASheetOnPostsIsAnOverhangAndOnWallsARoof) {
    const TriangleMesh roof{{{0, 0, 4}, {10, 0, 4}, {10, 8, 4.5F}, {0, 8, 4.5F}}, {{0, 2, 1}, {0, 3, 2}}};
    TriangleMesh shelter = roof, house = roof;
    for (const float x : {0.5F, 9.2F})
        for (const float y : {0.5F, 7.2F}) append(shelter, box({x, y, 0}, {x + 0.3F, y + 0.3F, 3.9F}));
    append(house, {{{0.1F, 0.1F, 0}, {9.9F, 0.1F, 0}, {9.9F, 0.1F, 3.9F}, {0.1F, 0.1F, 3.9F}},
                   {{0, 1, 2}, {0, 2, 3}}});
    append(house, {{{0.1F, 7.9F, 0}, {9.9F, 7.9F, 0}, {9.9F, 7.9F, 4.4F}, {0.1F, 7.9F, 4.4F}},
                   {{0, 1, 2}, {0, 2, 3}}});
    EXPECT_TRUE(partsOf(shelter, "", "").parts.at(0).isOverhanging);
    EXPECT_FALSE(partsOf(house, "", "").parts.at(0).isOverhanging);
    EXPECT_NEAR(area(partsOf(house, "", "").parts.at(0).footprint), 80, 1e-3);
}

TEST(MeshParts, OpenMeshIsUsedAndReported) {
    TriangleMesh open = box({0, 0, 0}, {10, 10, 10});
    open.triangles.erase(open.triangles.begin(), open.triangles.begin() + 2);
    const MeshParts made = partsOf(open, "", "");
    ASSERT_EQ(made.parts.size(), 1U);
    EXPECT_TRUE(warns(made.warnings, "not closed"));
    EXPECT_FALSE(made.parts[0].isOverhanging);
    EXPECT_NEAR(area(made.parts[0].footprint), 100, 1e-6);
}

Part slab(float x, float side, float bottom, float top) {
    return partsOf(box({x, 0, bottom}, {x + side, side, top}), "", "").parts.at(0);
}

TEST(MarkHanging, OnlyWhatNothingCarries) {
    std::vector<Part> parts{slab(0, 10, 0, 20), slab(0, 8, 20, 40), slab(6, 10, 20, 30), slab(30, 5, 50, 60),
                            slab(50, 5, 1.5F, 9)};
    markOverhangs(parts, flatGround);
    EXPECT_FALSE(parts[0].isOverhanging);
    EXPECT_FALSE(parts[1].isOverhanging);
    EXPECT_TRUE(parts[2].isOverhanging);
    EXPECT_TRUE(parts[3].isOverhanging);
    EXPECT_FALSE(parts[4].isOverhanging);
}

}  // namespace

}  // namespace noonmark
