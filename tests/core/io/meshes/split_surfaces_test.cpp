// Walls and roofs as separate meshes must give one building each, as if they were joined.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <map>

#include "core/city/meshes/mesh_topology.h"
#include "core/engines/api/engine_registry.h"
#include "core/io/meshes/mesh_units.h"
#include "core/io/read_city.h"
#include "core/receivers/roof_receivers.h"
#include "tests/core/city/mesh_fixtures.h"
#include "tests/core/engines/scenes.h"
#include "tests/core/io/piece_checks.h"
#include "tests/shared/shared_data.h"

namespace noonmark {
namespace {

FilePiece pieceOf(const std::vector<NamedMesh>& objects) {
    FilePiece piece;
    NoProgress progress;
    EXPECT_TRUE(addBuildings(objects, "file", piece, progress, {}));
    return piece;
}

enum class Surface { wall, roof, floor };

// The surface of a triangle by its slope; `lowM`: bottom of the building.
Surface surfaceOf(const TriangleMesh& mesh, glm::uvec3 t, float lowM) {
    const glm::dvec3 a(mesh.vertices[t.x]), b(mesh.vertices[t.y]), c(mesh.vertices[t.z]);
    const glm::dvec3 doubled = glm::cross(b - a, c - a);
    if (std::abs(doubled.z) < 0.02 * glm::length(doubled)) return Surface::wall;
    return std::max({a.z, b.z, c.z}) < double(lowM) + 0.1 ? Surface::floor : Surface::roof;
}

struct SplitMesh {
    TriangleMesh walls, roof, floor;
};

SplitMesh split(const TriangleMesh& mesh) {
    SplitMesh parts{{mesh.vertices, {}}, {mesh.vertices, {}}, {mesh.vertices, {}}};
    const float lowM = computeBox(mesh).low.z;
    for (const glm::uvec3 t : mesh.triangles) {
        const Surface surface = surfaceOf(mesh, t, lowM);
        TriangleMesh& to =
            surface == Surface::wall ? parts.walls : (surface == Surface::roof ? parts.roof : parts.floor);
        to.triangles.push_back(t);
    }
    return parts;
}

// A closed house, 8 m deep, from `west` to `east`, with walls of 6 m and a ridge along x at 9 m.
TriangleMesh house(float west, float east) {
    TriangleMesh mesh{{{west, 0, 0},
                       {east, 0, 0},
                       {east, 8, 0},
                       {west, 8, 0},
                       {west, 0, 6},
                       {east, 0, 6},
                       {east, 8, 6},
                       {west, 8, 6},
                       {west, 4, 9},
                       {east, 4, 9}},
                      {{0, 2, 1},
                       {0, 3, 2},
                       {0, 1, 5},
                       {0, 5, 4},
                       {2, 3, 7},
                       {2, 7, 6},
                       {1, 2, 6},
                       {1, 6, 5},
                       {3, 0, 4},
                       {3, 4, 7},
                       {5, 6, 9},
                       {7, 4, 8},
                       {4, 5, 9},
                       {4, 9, 8},
                       {6, 7, 8},
                       {6, 8, 9}}};
    EXPECT_EQ(findOpenEdges(mesh), 0U);
    return mesh;
}

void expectHouse(const Building& building, float west, float east) {
    ASSERT_EQ(building.parts.size(), 1U);
    const Part& part = building.parts[0];
    EXPECT_EQ(part.bottomM, 0);
    EXPECT_EQ(part.topM, 9);
    EXPECT_FALSE(part.isOverhanging);
    EXPECT_NEAR(area(part.footprint), 8 * double(east - west), 1e-3);
    EXPECT_NEAR(bounds(part.footprint).low.x, west, 0.011);
    EXPECT_NEAR(bounds(part.footprint).high.x, east, 0.011);
}

TEST(SplitSurfaces, NamesOfOneStemAreOneBuilding) {
    const SplitMesh parts = split(house(0, 10));
    const FilePiece piece = pieceOf({{"building_12_WallSurface", parts.walls},
                                     {"building_12_RoofSurface", parts.roof},
                                     {"building_12_GroundSurface", parts.floor}});
    ASSERT_EQ(piece.buildings.size(), 1U);
    EXPECT_EQ(piece.buildings[0]->name, "building_12");
    expectHouse(*piece.buildings[0], 0, 10);
    EXPECT_TRUE(piece.warnings.empty());
    EXPECT_NEAR(signedVolume(*piece.buildings[0]->parts[0].mesh), 8 * 10 * 7.5, 1e-3);
}

TEST(SplitSurfaces, AParentNamesItsSurfaces) {
    const SplitMesh parts = split(house(0, 10)), next = split(house(10, 18));
    const FilePiece piece = pieceOf({{"WallSurface", parts.walls, "House 1"},
                                     {"RoofSurface", parts.roof, "House 1"},
                                     {"WallSurface", next.walls, "House 2"},
                                     {"RoofSurface", next.roof, "House 2"}});
    ASSERT_EQ(piece.buildings.size(), 2U);
    EXPECT_EQ(piece.buildings[0]->name, "House 1");
    expectHouse(*piece.buildings[0], 0, 10);
    expectHouse(*piece.buildings[1], 10, 18);
}

// By geometry, without helpful names. Three houses in a row whose party walls exist twice.
TEST(SplitSurfaces, NeighboursWithAPartyWallStayThemselves) {
    const std::vector<std::pair<float, float>> row{{0, 10}, {10, 18}, {18, 30}};
    std::vector<NamedMesh> each, layers{{"mesh_0", {}}, {"mesh_1", {}}};
    for (const auto& [west, east] : row) {
        const SplitMesh parts = split(house(west, east));
        each.push_back({"", parts.walls});
        each.push_back({"", parts.roof});
        append(layers[0].mesh, parts.walls);
        append(layers[1].mesh, parts.roof);
    }
    for (const std::vector<NamedMesh>& objects : {each, layers}) {
        const FilePiece piece = pieceOf(objects);
        ASSERT_EQ(piece.buildings.size(), 3U);
        for (std::size_t i = 0; i < 3; ++i) expectHouse(*piece.buildings[i], row[i].first, row[i].second);
    }
}

// Two planes of one roof, each an object: no wall is under their ridge.
TEST(SplitSurfaces, RoofsThatMeetInARidgeAreOneBuilding) {
    const SplitMesh parts = split(house(0, 10));
    NamedMesh south{"a", {parts.roof.vertices, {}}}, north{"b", {parts.roof.vertices, {}}};
    for (const glm::uvec3 t : parts.roof.triangles)
        (std::min({parts.roof.vertices[t.x].y, parts.roof.vertices[t.y].y, parts.roof.vertices[t.z].y}) < 1
             ? south
             : north)
            .mesh.triangles.push_back(t);
    ASSERT_EQ(south.mesh.triangles.size(), 2U);
    const FilePiece piece = pieceOf({south, north, {"c", parts.walls}});
    ASSERT_EQ(piece.buildings.size(), 1U);
    expectHouse(*piece.buildings[0], 0, 10);
}

// A roof of 20 x 20 m at 6 m, with a house of 8 x 8 m rising from its middle to 12 m. `halved`: its walls are
// divided into halves, so that their edges are not those of the roof.
std::vector<NamedMesh> penthouse(bool halved) {
    NamedMesh roofs{"mesh_0", {}}, walls{"mesh_1", {}};
    const auto corner = [](float half, std::uint32_t i, float z) {
        return glm::vec3(i == 0 || i == 3 ? -half : half, i < 2 ? -half : half, z);
    };
    const auto quad = [](TriangleMesh& mesh, glm::vec3 a, glm::vec3 b, glm::vec3 c, glm::vec3 d) {
        append(mesh, {{a, b, c, d}, {{0, 1, 2}, {0, 2, 3}}});
    };
    for (std::uint32_t i = 0; i < 4; ++i) {
        const std::uint32_t j = (i + 1) % 4;
        quad(walls.mesh, corner(10, i, 0), corner(10, j, 0), corner(10, j, 6), corner(10, i, 6));
        quad(roofs.mesh, corner(10, i, 6), corner(10, j, 6), corner(4, j, 6), corner(4, i, 6));
        const glm::vec3 a = corner(4, i, 6), b = corner(4, j, 6), middle = (a + b) / 2.0F, up(0, 0, 6);
        if (!halved) quad(walls.mesh, a, b, b + up, a + up);
        if (halved) quad(walls.mesh, a, middle, middle + up, a + up);
        if (halved) quad(walls.mesh, middle, b, b + up, middle + up);
    }
    quad(roofs.mesh, corner(4, 0, 12), corner(4, 1, 12), corner(4, 2, 12), corner(4, 3, 12));
    return {roofs, walls};
}

TEST(SplitSurfaces, WhatStepsUpFromARoofBelongsToIt) {
    for (const bool halved : {false, true}) {
        const FilePiece piece = pieceOf(penthouse(halved));
        ASSERT_EQ(piece.buildings.size(), 1U) << halved;
        ASSERT_EQ(piece.buildings[0]->parts.size(), 1U) << halved;
        EXPECT_FALSE(piece.buildings[0]->parts[0].isOverhanging) << halved;
        EXPECT_NEAR(area(piece.buildings[0]->parts[0].footprint), 400, 0.1) << halved;
        EXPECT_EQ(topM(*piece.buildings[0]), 12);
    }
}

TEST(SurfaceNames, WhatIsLeftNamesTheBuilding) {
    EXPECT_EQ(stemOfSurfaceName("building_12_WallSurface"), "building_12");
    EXPECT_EQ(stemOfSurfaceName("Wall building_12 3"), "building_12_3");
    EXPECT_EQ(stemOfSurfaceName("building_12_RoofSurface.003"), "building_12");
    EXPECT_EQ(stemOfSurfaceName("House7Roof"), "House7");
    EXPECT_EQ(stemOfSurfaceName("4959_GroundSurface"), "4959");
    EXPECT_EQ(stemOfSurfaceName("Roof 3"), "");
    EXPECT_EQ(stemOfSurfaceName("roof.003"), "");
    EXPECT_EQ(stemOfSurfaceName("Cornwall House"), "");
    EXPECT_EQ(stemOfSurfaceName("mesh_1"), "");
    EXPECT_TRUE(isOnlySurfaceName("RoofSurface_2"));
    EXPECT_FALSE(isOnlySurfaceName("Roof Garden"));
    EXPECT_FALSE(isOnlySurfaceName(""));
}

TEST(SplitSurfaces, AFlatRoofLiesOnItsWalls) {
    const SplitMesh parts = split(tests::box({0, 0, 0}, {12, 9, 7}));
    const FilePiece piece = pieceOf({{"flat", parts.roof}, {"ring", parts.walls}});
    ASSERT_EQ(piece.buildings.size(), 1U);
    const Part& part = piece.buildings[0]->parts.at(0);
    EXPECT_FALSE(part.isOverhanging);
    EXPECT_EQ(part.bottomM, 0);
    EXPECT_EQ(part.topM, 7);
    EXPECT_NEAR(area(part.footprint), 108, 1e-3);
}

TEST(SplitSurfaces, ACanopyAloneIsABuildingInTheAir) {
    const SplitMesh parts = split(tests::box({0, 0, 4}, {12, 9, 5}));
    const FilePiece piece = pieceOf({{"canopy", parts.roof}});
    ASSERT_EQ(piece.buildings.size(), 1U);
    EXPECT_TRUE(piece.buildings[0]->parts.at(0).isOverhanging);
    EXPECT_EQ(topM(*piece.buildings[0]), 5);
    EXPECT_FALSE(tests::warns(piece, "casts no shadow"));
}

TEST(SplitSurfaces, ADeckIsSolidAndPavementIsGround) {
    const auto level = [](float z) { return split(tests::box({0, 0, z - 1}, {12, 9, z})).roof; };
    const FilePiece deck = pieceOf({{"deck", level(1.2F)}});
    ASSERT_EQ(deck.buildings.size(), 1U);
    EXPECT_FALSE(deck.buildings[0]->parts.at(0).isOverhanging);
    EXPECT_EQ(deck.buildings[0]->parts.at(0).bottomM, 0);
    const FilePiece pavement = pieceOf({{"street", level(0.05F)}, {"house", house(20, 30)}});
    EXPECT_EQ(pavement.buildings.size(), 1U);
    EXPECT_TRUE(tests::warns(pavement, "flat ground"));
    // At elevations above sea level the surface under two houses is ground.
    TriangleMesh houses = tests::joined(house(1, 4), house(6, 9)), plane = level(0);
    for (TriangleMesh* mesh : {&houses, &plane})
        for (glm::vec3& vertex : mesh->vertices) vertex.z += 515;
    EXPECT_EQ(pieceOf({{"plane", plane}, {"houses", houses}}).buildings.size(), 2U);
}

// Delfshaven's CityJSON, as it is and with separate walls and roofs.
class SplitDelfshaven : public testing::Test {
protected:
    void SetUp() override {
        const auto file = tests::sharedData("delfshaven/3-20-DELFSHAVEN.city.json");
        if (!file) GTEST_SKIP() << "without the shared data";
        NoProgress progress;
        auto read = readCity({*file}, {}, progress, {});
        ASSERT_TRUE(read) << read.error().text();
        joined = std::move(read->city);
    }

    // `key`: the name of an object by building and surface; equal names: one object.
    City splitBy(const std::function<std::string(std::size_t building, Surface)>& key) const {
        std::map<std::string, NamedMesh> objects;
        for (std::size_t i = 0; i < joined.buildings.size(); ++i)
            for (const Part& part : joined.buildings[i]->parts) {
                const SplitMesh parts = split(meshOf(part));
                for (const auto& [surface, mesh] : {std::pair{Surface::wall, &parts.walls},
                                                    {Surface::roof, &parts.roof},
                                                    {Surface::floor, &parts.floor}}) {
                    NamedMesh& object = objects[key(i, surface)];
                    object.name = key(i, surface);
                    append(object.mesh, *mesh);
                }
            }
        std::vector<NamedMesh> list;
        for (auto& [name, object] : objects) list.push_back(std::move(object));
        FilePiece piece = pieceOf(list);
        City city = joined;
        city.buildings = std::move(piece.buildings);
        return city;
    }

    static Receivers over(const City& city, ReceiverPlaces places) {
        return placeReceivers(city, makeRegionFromLocalBox({{-200, -200}, {200, 200}}), {1, places}).value();
    }

    // Cells of another kind, per cent; and roofs whose height differs by more than 1 cm.
    struct Difference {
        double kindPercent = 0;
        double roofPercent = 0;
        std::size_t roofs = 0;
    };
    Difference computeDifference(const City& city) const {
        const Receivers a = over(joined, ReceiverPlaces::both), b = over(city, ReceiverPlaces::both);
        Difference difference;
        double kinds = 0, roofs = 0;
        for (std::size_t i = 0; i < a.kind.size(); ++i) {
            kinds += a.kind[i] != b.kind[i] ? 1 : 0;
            if (a.kind[i] != CellKind::roof || b.kind[i] != CellKind::roof) continue;
            ++difference.roofs;
            roofs += std::abs(a.groundM[i] - b.groundM[i]) > 0.01F ? 1 : 0;
        }
        difference.kindPercent = 100 * kinds / double(a.kind.size());
        difference.roofPercent = 100 * roofs / double(difference.roofs);
        return difference;
    }

    void expectSameField(const City& city, const char* engine, double maxMeanMin) const {
        const SunSteps sun = tests::oneDay(tests::arc(270, 41), 2);
        NoProgress progress;
        const auto made = makeEngine(engine).value();
        const Receivers receivers = over(joined, ReceiverPlaces::ground);
        const ShadowField a = made->accumulate(joined, receivers, sun, progress, {}).value();
        const ShadowField b = made->accumulate(city, receivers, sun, progress, {}).value();
        double off = 0;
        for (const std::uint32_t cell : receivers.cells)
            off += double(std::abs(a.grossMin[cell] - b.grossMin[cell])) / double(receivers.cells.size());
        EXPECT_LE(off, maxMeanMin) << engine;
        RecordProperty(std::string("meanMin_") + engine, std::to_string(off));
    }

    void expectSame(const City& city, double maxKindPercent) const {
        const Difference difference = computeDifference(city);
        EXPECT_GT(difference.roofs, 10'000U);
        EXPECT_LE(difference.kindPercent, maxKindPercent);
        EXPECT_LE(difference.roofPercent, 0.1);
        expectSameField(city, "ray", 0.05);
        expectSameField(city, "projected", 0.05);
        expectSameField(city, "horizon", 0.1);
    }

    City joined;
};

TEST_F(SplitDelfshaven, ByNamesIsTheSameCity) {
    const City city = splitBy([](std::size_t i, Surface surface) {
        constexpr const char* names[] = {"WallSurface", "RoofSurface", "GroundSurface"};
        return "building_" + std::to_string(i) + "_" + names[int(surface)];
    });
    EXPECT_NEAR(double(city.buildings.size()), double(joined.buildings.size()), 10);
    expectSame(city, 0.1);
}

TEST_F(SplitDelfshaven, ByMaterialIsTheSameCity) {
    const City city = splitBy([](std::size_t, Surface surface) {
        constexpr const char* names[] = {"mesh_0", "mesh_1", "mesh_2"};
        return std::string(names[int(surface)]);
    });
    // Roofs of one house at several heights, which only names could join, are separate buildings.
    EXPECT_GT(city.buildings.size(), joined.buildings.size());
    expectSame(city, 0.7);
}

}  // namespace
}  // namespace noonmark
