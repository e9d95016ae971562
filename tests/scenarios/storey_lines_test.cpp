#include "core/city/meshes/mesh_section.h"

#include <gtest/gtest.h>

#include "scenarios/massing/massing.h"

namespace noonmark {
namespace {

Footprint plan() { return {{{0, 0}, {20, 0}, {20, 20}, {0, 20}}, {}}; }

TEST(StoreyLines, AreAtTheFloorsBetweenGroundAndTop) {
    Building building{.sourceId = "tower"};
    building.parts.push_back({.footprint = plan(), .bottomM = 5, .topM = 35});
    const auto lines = makeStoreyLines(building, 5, 4);
    ASSERT_EQ(lines.size(), 7U) << "at 4, 8, ... 28 m of 30";
    for (const auto& line : lines) EXPECT_EQ(line.size(), 4U);
    EXPECT_FLOAT_EQ(lines.front().front().z, 9);
    EXPECT_FLOAT_EQ(lines.back().front().z, 33);
    EXPECT_TRUE(makeStoreyLines(building, 5, 30).empty()) << "the roof is no floor";
}

TEST(StoreyLines, FollowLeaningWallsAndCourtyards) {
    Footprint court = plan();
    court.holes.push_back({{8, 8}, {8, 12}, {12, 12}, {12, 8}});
    const MassingSettings settings{.storeyHeightM = 4, .storeys = 10, .walls = {.taper = 0.5}};
    const Building tower = buildingOf(makeMassing(court, settings).value(), "tower").value();
    const auto lines = makeStoreyLines(tower, 0, 4);
    ASSERT_EQ(lines.size(), 18U) << "nine floors with an outer and an inner ring";
    float west = 100, east = -100;
    for (const auto& line : lines)
        for (const glm::vec3 point : line)
            if (point.z > 19.9F && point.z < 20.1F) {
                west = std::min(west, point.x);
                east = std::max(east, point.x);
            }
    EXPECT_NEAR(east - west, 15, 0.02) << "half way up to half the width";
}

}  // namespace
}  // namespace noonmark
