#include "core/city/meshes/surface_mesher.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <random>

namespace noonmark {
namespace {

using Outcome = SurfaceMesher::Outcome;

// Half the sum of the triangles' cross products: the area along the normal.
glm::dvec3 areaVector(const TriangleMesh& mesh) {
    glm::dvec3 sum(0);
    for (const glm::uvec3 t : mesh.triangles) {
        const glm::dvec3 a(mesh.vertices[t.x]);
        sum += glm::cross(glm::dvec3(mesh.vertices[t.y]) - a, glm::dvec3(mesh.vertices[t.z]) - a) / 2.0;
    }
    return sum;
}

Surface parseRing(std::size_t count) {
    Surface surface(1);
    for (std::size_t i = 0; i < count; ++i) surface[0].push_back(std::uint32_t(i));
    return surface;
}

TEST(SurfaceMesher, PolygonsInAnyPlaneKeepAreaAndSide) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> place(-1, 1);
    for (int trial = 0; trial < 300; ++trial) {
        const glm::dvec3 normal =
            glm::normalize(glm::dvec3(place(random), place(random), trial % 3 == 0 ? 0.0 : place(random)));
        const glm::dvec3 u = glm::normalize(glm::cross(normal, glm::dvec3(0.3, 0.5, 0.8)));
        const glm::dvec3 v = glm::cross(normal, u);
        const glm::dvec3 at(place(random) * 1000, place(random) * 1000, place(random) * 100);
        std::vector<glm::dvec3> points;  // a star: concave but simple
        const int corners = 4 + trial % 12;
        for (int i = 0; i < corners; ++i) {
            const double angle = 2 * 3.14159265358979 * i / corners;
            const double radius = 10 + 5 * place(random);
            points.push_back(at + radius * (std::cos(angle) * u + std::sin(angle) * v));
        }
        glm::dvec3 expected(0);
        for (std::size_t i = 0; i < points.size(); ++i)
            expected += glm::cross(points[i] - at, points[(i + 1) % points.size()] - at) / 2.0;
        SurfaceMesher mesher(points);
        ASSERT_EQ(mesher.add(parseRing(points.size())), Outcome::added);
        EXPECT_EQ(mesher.mesh().triangles.size(), points.size() - 2);
        EXPECT_NEAR(glm::distance(areaVector(mesher.mesh()), expected), 0, 0.01) << trial;
    }
}

TEST(SurfaceMesher, AWallWithAWindow) {
    const std::vector<glm::dvec3> points{{0, 0, 0}, {10, 0, 0}, {10, 0, 10}, {0, 0, 10},
                                         {4, 0, 4}, {4, 0, 6},  {6, 0, 6},   {6, 0, 4}};
    SurfaceMesher mesher(points);
    EXPECT_EQ(mesher.add({{0, 1, 2, 3}, {4, 5, 6, 7}}), Outcome::added);
    EXPECT_NEAR(areaVector(mesher.mesh()).y, -96, 1e-4);
}

TEST(SurfaceMesher, BentPolygonsUseTheirOwnPoints) {
    const std::vector<glm::dvec3> points{{0, 0, 0}, {10, 0, 0.2}, {12, 5, 0}, {10, 10, 0.3}, {0, 10, 0}};
    SurfaceMesher mesher(points);
    EXPECT_EQ(mesher.add(parseRing(5)), Outcome::added);
    EXPECT_EQ(mesher.mesh().vertices.size(), 5U);
    for (const glm::vec3 vertex : mesher.mesh().vertices)
        EXPECT_NE(
            std::find(points.begin(), points.end(), glm::dvec3(vertex)) == points.end() && vertex.z == 0,
            true);
}

TEST(SurfaceMesher, CrossingPolygonsAreRepaired) {
    const std::vector<glm::dvec3> points{{0, 0, 5}, {10, 10, 5}, {10, 0, 5}, {0, 11, 5}};
    SurfaceMesher mesher(points);
    EXPECT_EQ(mesher.add(parseRing(4)), Outcome::repaired);
    for (const glm::vec3 vertex : mesher.mesh().vertices) EXPECT_NEAR(vertex.z, 5, 1e-5);
}

TEST(SurfaceMesher, WhatHasNoAreaAddsNothing) {
    const std::vector<glm::dvec3> points{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 0, 0}, {NAN, 0, 0}, {0, 1, 0}};
    SurfaceMesher mesher(points);
    for (const Surface& surface : {Surface{}, Surface{{}}, Surface{{0}}, Surface{{0, 1}}, Surface{{0, 1, 2}},
                                   Surface{{0, 1, 3}}, Surface{{0, 1, 4, 5}}, Surface{{0, 0, 0, 0}}})
        EXPECT_EQ(mesher.add(surface), Outcome::degenerate);
    EXPECT_TRUE(mesher.mesh().triangles.empty());
}

}  // namespace
}  // namespace noonmark
