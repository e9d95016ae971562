#include "core/city/mesh_parts.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/city/mesh_outline.h"
#include "tests/core/city/mesh_fixtures.h"

namespace noonmark {
namespace {

using tests::box;

float flatGround(glm::dvec2) { return 0; }

bool warns(const Warnings& warnings, const std::string& what) {
    return std::any_of(warnings.begin(), warnings.end(),
                       [&](const Warning& w) { return w.what.find(what) != w.what.npos; });
}

TEST(MeshOutline, ofABoxIsItsBaseWithFourCorners) {
    const MeshOutline outline = outlineOf(box({1, 2, 3}, {11, 22, 33}), true);
    ASSERT_EQ(outline.pieces.size(), 1U);
    EXPECT_EQ(outline.pieces[0].outer.size(), 4U);
    EXPECT_NEAR(signedArea(outline.pieces[0].outer), 200, 1e-6);
    EXPECT_FALSE(outline.convexHull);
}

TEST(MeshOutline, farFromTheOriginStaysSimple) {
    const TriangleMesh mesh = box({29000, -31000, 0}, {29010.1F, -30990.3F, 33});
    const MeshOutline outline = outlineOf(mesh, true);
    ASSERT_EQ(outline.pieces.size(), 1U);
    EXPECT_EQ(outline.pieces[0].outer.size(), 4U);
    EXPECT_NEAR(area(outline.pieces[0]), 10.1 * 9.7, 0.1);
}

// A fan of triangles in float32 far out, where their corners fall between millimetres: still one outline.
TEST(MeshOutline, trianglesThatShareCornersAreNeverParted) {
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
        const MeshOutline outline = outlineOf(roof, false);
        ASSERT_EQ(outline.pieces.size(), 1U) << trial;
        EXPECT_TRUE(outline.pieces[0].holes.empty());
    }
}

TEST(MeshOutline, aHairlineGapDoesNotPartABuilding) {
    const TriangleMesh halves = tests::joined(box({0, 0, 0}, {5, 10, 10}), box({5.004F, 0, 0}, {10, 10, 10}));
    const MeshOutline outline = outlineOf(halves, true);
    ASSERT_EQ(outline.pieces.size(), 1U);
    EXPECT_NEAR(area(outline.pieces[0]), 100, 0.01);
    EXPECT_EQ(outline.pieces[0].outer.size(), 4U);
    EXPECT_EQ(outlineOf(tests::joined(box({0, 0, 0}, {5, 10, 10}), box({5.1F, 0, 0}, {10, 10, 10})), true)
                  .pieces.size(),
              2U);
}

TEST(MeshOutline, wallsAloneHaveTheirHull) {
    TriangleMesh walls = box({0, 0, 0}, {10, 10, 10});
    walls.triangles.erase(walls.triangles.begin(), walls.triangles.begin() + 4);
    const MeshOutline outline = outlineOf(walls, false);
    ASSERT_EQ(outline.pieces.size(), 1U);
    EXPECT_TRUE(outline.convexHull);
    EXPECT_NEAR(area(outline.pieces[0]), 100, 1e-6);
}

TEST(MeshOutline, aWallLineIsNoOverlap) {
    const auto outline = [](glm::vec3 low, glm::vec3 high) { return outlineOf(box(low, high), true).pieces; };
    const auto groups = overlapGroups({outline({0, 0, 0}, {10, 10, 10}), outline({10, 0, 0}, {20, 10, 10}),
                                       outline({2, 2, 10}, {8, 8, 20}), outline({7, 7, 20}, {9, 9, 30})});
    EXPECT_EQ(groups, (std::vector<std::size_t>{0, 1, 0, 0}));
}

TEST(MeshParts, aBoxIsOnePart) {
    const MeshParts made = partsOf(tests::unshared(box({0, 0, 1}, {10, 10, 31})), "tower", "file: tower");
    ASSERT_EQ(made.parts.size(), 1U);
    const Part& part = made.parts[0];
    EXPECT_TRUE(made.warnings.empty());
    EXPECT_EQ(part.sourceId, "tower");
    EXPECT_EQ(part.heightSource, HeightSource::mesh);
    EXPECT_EQ(part.bottomM, 1);
    EXPECT_EQ(part.topM, 31);
    EXPECT_FALSE(part.hangs);
    EXPECT_EQ(openEdges(*part.mesh), 0U);
    EXPECT_NEAR(signedVolume(*part.mesh), 3000, 1e-6);
}

TEST(MeshParts, piecesApartAreParts) {
    const MeshParts made =
        partsOf(tests::joined(box({0, 0, 0}, {1, 1, 5}), box({4, 0, 0}, {6, 2, 9})), "two", "two");
    ASSERT_EQ(made.parts.size(), 2U);
    EXPECT_NEAR(signedVolume(*made.parts[0].mesh) + signedVolume(*made.parts[1].mesh), 5 + 36, 1e-6);
    for (const Part& part : made.parts)
        EXPECT_NEAR(signedVolume(*part.mesh), area(part.footprint) * double(part.topM - part.bottomM), 1e-6);
}

TEST(MeshParts, overhangIsSeenAndCavityIsNot) {
    const TriangleMesh table = tests::joined(box({4, 4, 0}, {6, 6, 10}), box({0, 0, 10}, {10, 10, 12}));
    EXPECT_TRUE(hasOpenAirBelow(table));
    TriangleMesh cavity = box({2, 2, 3}, {8, 8, 9});
    turnInsideOut(cavity);
    EXPECT_FALSE(hasOpenAirBelow(tests::joined(box({0, 0, 0}, {10, 10, 12}), cavity)));
    EXPECT_FALSE(hasOpenAirBelow(box({0, 0, 50}, {10, 10, 60})));  // that is for markHanging
}

TEST(MeshParts, leaningWallIsAnOverhang) {
    TriangleMesh funnel = box({0, 0, 0}, {10, 10, 20});
    for (int i = 4; i < 8; ++i) funnel.vertices[std::size_t(i)].x += i % 2 == 0 ? -5.0F : 5.0F;
    EXPECT_TRUE(hasOpenAirBelow(funnel));
}

TEST(MeshParts, whatCannotCastAShadowIsSaid) {
    const TriangleMesh flat = box({0, 0, 0}, {10, 10, 0});
    EXPECT_TRUE(warns(partsOf(flat, "", "").warnings, "no height"));
    TriangleMesh sheet;
    sheet.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 0, 1}};
    sheet.triangles = {{0, 1, 2}};
    EXPECT_TRUE(warns(partsOf(sheet, "", "").warnings, "sheet"));
    EXPECT_TRUE(partsOf(sheet, "", "").parts.empty());
    EXPECT_TRUE(partsOf({}, "", "").parts.empty());
}

TEST(MeshParts, openMeshIsUsedAndSaid) {
    TriangleMesh open = box({0, 0, 0}, {10, 10, 10});
    open.triangles.erase(open.triangles.begin(), open.triangles.begin() + 2);
    const MeshParts made = partsOf(open, "", "");
    ASSERT_EQ(made.parts.size(), 1U);
    EXPECT_TRUE(warns(made.warnings, "not closed"));
    EXPECT_FALSE(made.parts[0].hangs);
    EXPECT_NEAR(area(made.parts[0].footprint), 100, 1e-6);
}

Part slab(float x, float side, float bottom, float top) {
    return partsOf(box({x, 0, bottom}, {x + side, side, top}), "", "").parts.at(0);
}

TEST(MarkHanging, onlyWhatNothingCarries) {
    std::vector<Part> parts{slab(0, 10, 0, 20), slab(0, 8, 20, 40), slab(6, 10, 20, 30), slab(30, 5, 50, 60),
                            slab(50, 5, 1.5F, 9)};
    markHanging(parts, flatGround);
    EXPECT_FALSE(parts[0].hangs);
    EXPECT_FALSE(parts[1].hangs);
    EXPECT_TRUE(parts[2].hangs);
    EXPECT_TRUE(parts[3].hangs);
    EXPECT_FALSE(parts[4].hangs);
}

}  // namespace
}  // namespace noonmark
