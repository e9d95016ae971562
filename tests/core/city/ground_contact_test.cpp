#include "core/city/terrain/building_ground.h"

#include <gtest/gtest.h>

#include "core/city/city.h"
#include "core/receivers/receivers.h"

namespace noonmark {
namespace {

Ring square(float low, float high) { return {{low, low}, {high, low}, {high, high}, {low, high}}; }

Part prism(Ring ring, float bottomM, float topM, bool isOverhanging) {
    return {
        .footprint = {std::move(ring), {}}, .bottomM = bottomM, .topM = topM, .isOverhanging = isOverhanging};
}

// A body on the ground from 2 to 8, with a slab of eaves from 0 to 10 on top, as one mesh.
Part houseWithEaves(float liftM) {
    const TriangleMesh body = meshOf(prism(square(2, 8), liftM, liftM + 6, false));
    TriangleMesh all = meshOf(prism(square(0, 10), liftM + 6, liftM + 7, false));
    const auto first = std::uint32_t(all.vertices.size());
    all.vertices.insert(all.vertices.end(), body.vertices.begin(), body.vertices.end());
    for (const glm::uvec3 triangle : body.triangles) all.triangles.push_back(triangle + first);
    Part part = prism(square(0, 10), liftM, liftM + 7, true);
    part.mesh = std::make_shared<const TriangleMesh>(std::move(all));
    return part;
}

double areaOf(const std::vector<Footprint>& polygons) {
    double sum = 0;
    for (const Footprint& polygon : polygons) sum += area(polygon);
    return sum;
}

TEST(GroundContact, AStandingPartIsItsFootprintAndAHangingPrismNothing) {
    EXPECT_DOUBLE_EQ(areaOf(findGroundContact(prism(square(0, 10), 0, 5, false), 0)), 100);
    EXPECT_TRUE(findGroundContact(prism(square(0, 10), 4, 5, true), 0).empty());
}

TEST(GroundContact, EavesDoNotTakeTheGroundBelowThem) {
    EXPECT_NEAR(areaOf(findGroundContact(houseWithEaves(0), 0)), 36, 1e-4);
    EXPECT_NEAR(areaOf(findGroundContact(houseWithEaves(20), 20)), 36, 1e-4);
    EXPECT_TRUE(findGroundContact(houseWithEaves(4), 0).empty());  // all of it above the ground
}

TEST(GroundContact, AShellOpenBelowTakesWhatItsWallsEnclose) {
    Part part = houseWithEaves(0);
    TriangleMesh open = *part.mesh;
    std::erase_if(open.triangles, [&](glm::uvec3 t) {
        return open.vertices[t.x].z + open.vertices[t.y].z + open.vertices[t.z].z == 0;
    });
    part.mesh = std::make_shared<const TriangleMesh>(open);
    EXPECT_NEAR(areaOf(findGroundContact(part, 0)), 36, 1e-4);
}

// The ground under a canopy with a wall on one side is free.
TEST(GroundContact, AWallThatEnclosesNothingTakesNothing) {
    Part part = prism(square(0, 10), 0, 5, true);
    part.mesh = std::make_shared<const TriangleMesh>(
        TriangleMesh{{{0, 0, 5}, {10, 0, 5}, {10, 10, 5}, {0, 10, 5}, {0, 0, 0}, {10, 0, 0}},
                     {{0, 1, 2}, {0, 2, 3}, {4, 5, 1}, {4, 1, 0}}});
    EXPECT_TRUE(findGroundContact(part, 0).empty());
}

TEST(GroundContact, ReceiversLieUnderTheEavesButNotInTheHouse) {
    City city;
    city.buildings.push_back(std::make_shared<const Building>(Building{.parts = {houseWithEaves(0)}}));
    const Receivers receivers =
        placeReceiversOnGround(city, makeRegionFromLocalBox({{0, 0}, {10, 10}}), {1}).value();
    EXPECT_EQ(receivers.cells.size(), 64U);
    EXPECT_EQ(receivers.kind[receivers.grid.index(5, 5)], CellKind::building);
    EXPECT_EQ(receivers.kind[receivers.grid.index(0, 0)], CellKind::ground);
}

}  // namespace
}  // namespace noonmark
