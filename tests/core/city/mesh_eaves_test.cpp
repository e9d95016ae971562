#include "core/city/meshes/mesh_parts.h"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace noonmark
