#include <gtest/gtest.h>
#include <cmath>
#include <memory>
#include <random>

#include "core/city/footprints/plan_areas.h"
#include "core/city/footprints/plan_overlay.h"
#include "core/city/meshes/mesh_outline.h"
#include "core/city/meshes/mesh_parts.h"
#include "core/city/meshes/mesh_section.h"
#include "tests/core/city/mesh_fixtures.h"

namespace noonmark {

namespace {

using tests::box;

Building buildingOfMesh(const TriangleMesh& mesh) {
    Building building{.sourceId = "mesh"};
    building.parts = partsOf(mesh, "mesh", "mesh").parts;
    return building;
}

// A solid with a square of side 2 x `baseM` at the bottom and 2 x `topM` at `heightM`.
TriangleMesh taper(float baseM, float topM, float heightM) {
    TriangleMesh mesh = box({-baseM, -baseM, 0}, {baseM, baseM, heightM});
    for (int i = 4; i < 8; ++i) {
        glm::vec3& corner = mesh.vertices[std::size_t(i)];
        corner.x = corner.x > 0 ? topM : -topM;
        corner.y = corner.y > 0 ? topM : -topM;
    }
    return mesh;
}

// 40 x 40 m tapering to 20 x 20 at 40 m, storeys of 3.2 m: with the base on every storey it would be 12.5 ->
// 13 x 1600 m2.
TEST(FloorArea, OfATaperIsTheSumOfItsSections) {
    double expected = 0;
    int storeys = 0;
    for (double floor = 0; floor + 1.6 < 40; floor += 3.2, ++storeys) {
        const double side = 40 - (floor + 0.01) * 20 / 40;
        expected += side * side;
    }
    const FloorArea floors = computeFloorArea(buildingOfMesh(taper(20, 10, 40)), 0, 3.2);
    EXPECT_EQ(floors.storeys, storeys);
    EXPECT_EQ(floors.estimatedStoreys, 0);
    EXPECT_NEAR(floors.grossM2, expected, 0.5);
    EXPECT_LT(floors.grossM2, 0.65 * 13 * 1600);
}

// Floors at 0, 3, ... 27 of a pyramid of 30 x 30 x 30 m: sides 30, 27, ... 3, so 9 x (1 + 4 + ... + 100) =
// 3465.
TEST(FloorArea, OfAPyramidIsWorkedOut) {
    const FloorArea floors = computeFloorArea(buildingOfMesh(taper(15, 0.0005F, 30)), 0, 3);
    EXPECT_EQ(floors.storeys, 10);
    // Sections 1 cm above the floor are smaller by 2 x 0.01 x 165 in all
    EXPECT_NEAR(floors.grossM2, 3465, 4);
    EXPECT_NEAR(floors.grossM2, 3465 - 2 * 0.01 * 165, 0.05);
}

TEST(FloorArea, ABoxOfTrianglesIsThatPrism) {
    Building prism{.sourceId = "prism"};
    prism.parts.push_back({.footprint = {{{0, 0}, {20, 0}, {20, 30}, {0, 30}}, {}}, .topM = 35});
    const FloorArea asPrism = computeFloorArea(prism, 0, 3.5);
    const FloorArea asMesh = computeFloorArea(buildingOfMesh(box({0, 0, 0}, {20, 30, 35})), 0, 3.5);
    EXPECT_NEAR(asPrism.grossM2, 6000, 1e-6);
    EXPECT_NEAR(asMesh.grossM2, 6000, 0.01);
    EXPECT_EQ(asPrism.storeys, 10);
    EXPECT_EQ(asMesh.storeys, 10);
}

// A podium of 40 x 40 to 12 m and a tower of 20 x 20 from 12 to 52 m, as prisms and as meshes; and the same
// tower from the ground up, inside the podium: its floors there count once.
TEST(FloorArea, PartsAtSeveralHeightsAreEachCountedOnce) {
    const double expected = 3 * 1600 + 10 * 400;
    const auto prism = [](float low, float high, float bottom, float top) {
        return Part{.footprint = {{{low, low}, {high, low}, {high, high}, {low, high}}, {}},
                    .bottomM = bottom,
                    .topM = top};
    };
    Building stacked{.parts = {prism(0, 40, 0, 12), prism(10, 30, 12, 52)}};
    Building nested{.parts = {prism(0, 40, 0, 12), prism(10, 30, 0, 52)}};
    EXPECT_NEAR(computeFloorArea(stacked, 0, 4).grossM2, expected, 0.01);
    EXPECT_NEAR(computeFloorArea(nested, 0, 4).grossM2, expected, 0.01);
    const TriangleMesh meshes = tests::joined(box({0, 0, 0}, {40, 40, 12}), box({10, 10, 12}, {30, 30, 52}));
    EXPECT_NEAR(computeFloorArea(buildingOfMesh(meshes), 0, 4).grossM2, expected, 0.01);
    const TriangleMesh overlapping =
        tests::joined(box({0, 0, 0}, {40, 40, 12}), box({10, 10, 0}, {30, 30, 52}));
    EXPECT_NEAR(computeFloorArea(buildingOfMesh(overlapping), 0, 4).grossM2, expected, 0.01);
}

// A block of 40 x 40 x 20 m around a court of 20 x 20 m: five storeys of 1200 m2.
TriangleMesh courtyardBlock() {
    TriangleMesh mesh;
    const auto ring = [&](float half, float z) {
        for (const glm::vec2 c : {glm::vec2(-1, -1), {1, -1}, {1, 1}, {-1, 1}})
            mesh.vertices.emplace_back(c * half, z);
    };
    ring(20, 0), ring(20, 20), ring(10, 0), ring(10, 20);
    for (std::uint32_t i = 0; i < 4; ++i) {
        const std::uint32_t j = (i + 1) % 4;
        const auto quad = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
            mesh.triangles.insert(mesh.triangles.end(), {{a, b, c}, {a, c, d}});
        };
        quad(i, j, 4 + j, 4 + i);            // outer wall
        quad(8 + j, 8 + i, 12 + i, 12 + j);  // wall of the court
        quad(4 + i, 4 + j, 12 + j, 12 + i);  // roof
        quad(j, i, 8 + i, 8 + j);            // floor
    }
    return mesh;
}

TEST(FloorArea, ACourtyardIsNoFloor) {
    ASSERT_EQ(findOpenEdges(courtyardBlock()), 0U);
    const FloorArea floors = computeFloorArea(buildingOfMesh(courtyardBlock()), 0, 4);
    EXPECT_NEAR(floors.grossM2, 5 * 1200, 0.05);
    EXPECT_EQ(floors.estimatedStoreys, 0);
}

// Without a floor it still has a court; without one outer wall too, a line closes the gap, and the result
// states that.
TEST(FloorArea, OpenMeshesAreMeasuredAndAMissingWallIsStated) {
    TriangleMesh open = courtyardBlock();
    std::erase_if(open.triangles, [&](glm::uvec3 t) {
        return open.vertices[t.x].z + open.vertices[t.y].z + open.vertices[t.z].z == 0;
    });
    const FloorArea floors = computeFloorArea(buildingOfMesh(open), 0, 4);
    EXPECT_NEAR(floors.grossM2, 5 * 1200, 0.05);
    EXPECT_EQ(floors.estimatedStoreys, 0);
    TriangleMesh house = box({0, 0, 0}, {8, 12, 12});
    std::erase_if(house.triangles, [&](glm::uvec3 t) {
        return house.vertices[t.x].x == 8 && house.vertices[t.y].x == 8 && house.vertices[t.z].x == 8;
    });
    const FloorArea estimated = computeFloorArea(buildingOfMesh(house), 0, 3);
    EXPECT_NEAR(estimated.grossM2, 4 * 96, 0.05);
    EXPECT_EQ(estimated.estimatedStoreys, 4);
}

TEST(MeshSection, ACavityIsOutAndWhatOverlapsCountsOnce) {
    TriangleMesh hollow = box({0, 0, 0}, {10, 10, 10});
    TriangleMesh cavity = box({2, 2, 2}, {8, 8, 8});
    turnInsideOut(cavity);
    append(hollow, cavity);
    EXPECT_NEAR(area(cutSection(hollow, 5).pieces), 100 - 36, 1e-3);
    EXPECT_NEAR(area(cutSection(hollow, 1).pieces), 100, 1e-3);
    EXPECT_TRUE(cutSection(hollow, 11).pieces.empty());
    const TriangleMesh overlapping =
        tests::joined(box({0, 0, 0}, {10, 10, 10}), box({5, 5, 0}, {15, 15, 10}));
    EXPECT_NEAR(area(cutSection(overlapping, 5).pieces), 175, 1e-3);
}

Footprint sizedRectangle(float west, float south, float width, float height) {
    return {{{west, south}, {west + width, south}, {west + width, south + height}, {west, south + height}},
            {}};
}

double sumOf(const std::vector<Footprint>& footprints) {
    double sum = 0;
    for (const Footprint& footprint : footprints) sum += area(footprint);
    return sum;
}

// A star around a place: simple, and neither convex nor aligned.
Footprint star(std::mt19937& random) {
    std::uniform_real_distribution<float> place(0, 60), reach(5, 40);
    const glm::vec2 middle(place(random), place(random));
    const int points = 5 + int(random() % 20);
    Footprint footprint;
    for (int i = 0; i < points; ++i) {
        const float angle = 6.2831853F * float(i) / float(points), radius = reach(random);
        footprint.outer.emplace_back(middle.x + radius * std::cos(angle),
                                     middle.y + radius * std::sin(angle));
    }
    return footprint;
}

TEST(AreaShared, OfRectanglesIsWhatTheirSidesSay) {
    const Footprint square = sizedRectangle(0, 0, 10, 10);
    EXPECT_NEAR(computeSharedArea(square, sizedRectangle(5, 5, 10, 10)), 25, 1e-9);
    EXPECT_NEAR(computeSharedArea(square, sizedRectangle(2, 3, 4, 5)), 20, 1e-9);
    EXPECT_NEAR(computeSharedArea(sizedRectangle(2, 3, 4, 5), square), 20, 1e-9);
    EXPECT_NEAR(computeSharedArea(square, square), 100, 1e-9);
    EXPECT_EQ(computeSharedArea(square, sizedRectangle(10, 0, 5, 5)), 0);
    EXPECT_EQ(computeSharedArea(square, sizedRectangle(0, 10, 5, 5)), 0);
}

TEST(AreaShared, LeavesOutHoles) {
    Footprint yard = sizedRectangle(0, 0, 30, 30);
    yard.holes.push_back({{10, 10}, {10, 20}, {20, 20}, {20, 10}});
    EXPECT_NEAR(computeSharedArea(yard, sizedRectangle(0, 0, 30, 30)), 800, 1e-9);
    EXPECT_NEAR(computeSharedArea(yard, sizedRectangle(12, 12, 5, 5)), 0, 1e-9);
    EXPECT_NEAR(computeSharedArea(sizedRectangle(15, 15, 10, 10), yard), 75, 1e-9);
}

TEST(AreaShared, EqualsAnOverlayOfShapes) {
    std::mt19937 random(3);
    for (int round = 0; round < 300; ++round) {
        const Footprint a = star(random), b = star(random);
        EXPECT_NEAR(computeSharedArea(a, b), sumOf(cutSharedPieces({a}, {b})), 0.011) << round;
    }
}

TEST(AreaShared, KeepsItsAccuracyFarFromTheOrigin) {
    const Footprint far = sizedRectangle(8000, -9000, 100, 50);
    EXPECT_NEAR(computeSharedArea(far, sizedRectangle(8050, -9000, 100, 25)), 1250, 1e-6);
}

TEST(AreaOutside, LiesWithinItsBounds) {
    std::mt19937 random(5);
    for (int round = 0; round < 100; ++round) {
        const Footprint whole = star(random);
        const std::vector<Footprint> others{star(random), star(random), star(random)};
        const OutsideArea bound = boundAreaOutside({whole}, others);
        const double outside = computeAreaOutside(whole, others);
        EXPECT_LE(bound.minM2, outside + 0.05) << round;
        EXPECT_GE(bound.maxM2, outside - 0.05) << round;
    }
}

TEST(AreaOutside, IsExactWhereCoversAreDisjoint) {
    const OutsideArea bound = boundAreaOutside({sizedRectangle(0, 0, 10, 10), sizedRectangle(20, 0, 10, 10)},
                                               {sizedRectangle(0, 0, 4, 10), sizedRectangle(4, 0, 22, 5)});
    EXPECT_NEAR(bound.minM2, 200 - 40 - 30 - 30, 1e-9);
    EXPECT_NEAR(bound.maxM2, bound.minM2, 1e-9);
}

TEST(AreaOutside, OfShapesWithTooManyPointsIsNotBounded) {
    Footprint round;
    for (int i = 0; i < 2000; ++i)
        round.outer.emplace_back(50 * std::cos(float(i) * 0.00314159F),
                                 50 * std::sin(float(i) * 0.00314159F));
    const OutsideArea bound = boundAreaOutside({round}, {round});
    EXPECT_EQ(bound.minM2, 0);
    EXPECT_NEAR(bound.maxM2, area(round), 1e-6);
}

}  // namespace

}  // namespace noonmark
