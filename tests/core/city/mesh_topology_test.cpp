#include "core/city/meshes/mesh_topology.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tests/core/city/mesh_fixtures.h"

namespace noonmark {
namespace {

using tests::box;

TEST(MeshTopology, WeldingClosesABoxOfLooseTriangles) {
    const TriangleMesh loose = tests::unshared(box({0, 0, 0}, {10, 20, 30}));
    EXPECT_EQ(findOpenEdges(loose), 36U);
    const TriangleMesh whole = weld(loose);
    EXPECT_EQ(whole.vertices.size(), 8U);
    EXPECT_EQ(findOpenEdges(whole), 0U);
    EXPECT_NEAR(signedVolume(whole), 6000, 1e-6);
}

TEST(MeshTopology, WeldingTakesPointsWithinTheToleranceWhereverTheyLie) {
    std::mt19937 random(7);
    std::uniform_real_distribution<float> place(-100, 100), noise(-0.0002F, 0.0002F);
    for (int i = 0; i < 200; ++i) {
        TriangleMesh loose = tests::unshared(box({0, 0, 0}, {1, 1, 1}));
        const glm::vec3 shift(place(random), place(random), place(random));
        for (glm::vec3& vertex : loose.vertices)
            vertex += shift + glm::vec3(noise(random), noise(random), noise(random));
        const TriangleMesh whole = weld(loose);
        EXPECT_EQ(whole.vertices.size(), 8U);
        EXPECT_EQ(findOpenEdges(whole), 0U);
    }
}

TEST(MeshTopology, WeldingTakesPointsHoweverFarAway) {
    TriangleMesh mesh = box({0, 0, 0}, {1, 1, 1});
    mesh.vertices.emplace_back(1e30F, 0, 0);
    mesh.vertices.emplace_back(2e30F, -3e38F, 0);
    mesh.vertices.emplace_back(1e30F, 0, 0);
    mesh.triangles.insert(mesh.triangles.end(), {{0, 8, 9}, {0, 9, 10}});
    const TriangleMesh whole = weld(tests::unshared(mesh));
    EXPECT_EQ(whole.vertices.size(), 10U);
    EXPECT_EQ(whole.triangles.size(), 14U);
}

TEST(MeshTopology, UselessTrianglesGo) {
    TriangleMesh mesh = box({0, 0, 0}, {1, 1, 1});
    mesh.vertices.emplace_back(NAN, 0, 0);
    mesh.vertices.emplace_back(0.5F, 0, 0);
    mesh.triangles.insert(mesh.triangles.end(), {{0, 0, 1}, {0, 1, 8}, {0, 9, 1}});
    TriangleMesh clean = weld(mesh);
    EXPECT_EQ(clean.triangles.size(), 13U);
    EXPECT_EQ(removeDegenerateTriangles(clean), 1U);
    EXPECT_EQ(findOpenEdges(clean), 0U);
}

TEST(MeshTopology, OneWallMissingIsSeen) {
    TriangleMesh mesh = box({0, 0, 0}, {1, 1, 1});
    mesh.triangles.resize(10);
    EXPECT_EQ(findOpenEdges(mesh), 4U);
}

TEST(MeshTopology, ComponentsAreThePiecesThatShareNoPoint) {
    const TriangleMesh two = tests::joined(box({0, 0, 0}, {1, 1, 1}), box({5, 0, 0}, {7, 2, 2}));
    const Components components = findComponents(two);
    ASSERT_EQ(components.count, 2U);
    const auto meshes = separateComponents(two, components);
    EXPECT_NEAR(signedVolume(meshes[0]), 1, 1e-9);
    EXPECT_NEAR(signedVolume(meshes[1]), 8, 1e-9);
}

TEST(MeshTopology, InwardFacesAreTurnedButCavitiesStay) {
    TriangleMesh cavity = box({2, 2, 2}, {4, 4, 4});
    turnInsideOut(cavity);
    TriangleMesh hollow = tests::joined(box({0, 0, 0}, {10, 10, 10}), cavity);
    EXPECT_EQ(turnOutward(hollow), 0U);
    EXPECT_NEAR(signedVolume(hollow), 992, 1e-6);
    TriangleMesh inverted = box({0, 0, 0}, {2, 2, 2});
    turnInsideOut(inverted);
    EXPECT_EQ(turnOutward(inverted), 1U);
    EXPECT_NEAR(signedVolume(inverted), 8, 1e-9);
}

}  // namespace
}  // namespace noonmark
