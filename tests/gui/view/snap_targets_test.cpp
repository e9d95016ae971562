#include "app/gui/view/panel/point_input.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "tests/gui/small_city.h"

namespace noonmark {
namespace {

// One pixel a metre. South House has its corners at (-20, -60) and (20, -20).
const SnapReach reach10{glm::dmat2(1), 10};

TEST(SnapTargets, ACornerComesBeforeANearerEdge) {
    const SnapTargets targets(test::smallCity());
    EXPECT_EQ(targets.find({26, -24}, reach10), (Snap{SnapKind::corner, {20, -20}}))
        << "7.2 m from the corner, 6 m from the edge";
    EXPECT_EQ(targets.find({17, -26}, reach10), (Snap{SnapKind::corner, {20, -20}})) << "from inside too";
}

TEST(SnapTargets, WithoutACornerWithinReachTheNearestPointOfAnEdgeCounts) {
    const SnapTargets targets(test::smallCity());
    EXPECT_EQ(targets.find({26, -45}, reach10), (Snap{SnapKind::edge, {20, -45}}));
    EXPECT_FALSE(targets.find({30.5, -45}, reach10)) << "10.5 m away";
    EXPECT_FALSE(targets.find({0, -40}, reach10)) << "the middle of the building, 20 m from its edges";
}

TEST(SnapTargets, OfTwoCornersTheNearerOnTheScreenCounts) {
    City city = test::smallCity();
    SnapTargets targets(city);
    targets.setLots({test::square({26, -20}, 30)});
    EXPECT_EQ(targets.find({22, -20}, reach10)->point, glm::dvec2(20, -20));
    EXPECT_EQ(targets.find({24, -20}, reach10)->point, glm::dvec2(26, -20)) << "of the lot";
    // Seen flatly, ten metres north are one pixel: then 6 m east are further than 30 m north.
    const SnapReach flat{glm::dmat2(1, 0, 0, 0.1), 10};
    targets.setLots({test::square({20, 10}, 30)});
    EXPECT_EQ(targets.find({20, -4}, flat)->point, glm::dvec2(20, 10)) << "14 m of 16 m";
    EXPECT_EQ(targets.find({20, -6}, flat)->point, glm::dvec2(20, -20));
}

TEST(SnapTargets, TheLineBeingDrawnCountsToo) {
    const SnapTargets targets;
    const std::vector<glm::dvec2> line{{100, 100}, {150, 100}, {150, 140}};
    EXPECT_EQ(targets.find({104, 103}, reach10, line), (Snap{SnapKind::corner, {100, 100}}));
    EXPECT_EQ(targets.find({125, 92}, reach10, line), (Snap{SnapKind::edge, {125, 100}}));
    EXPECT_FALSE(targets.find({125, 120}, reach10, line)) << "the line is open";
}

TEST(SnapTargets, OverhangsCountOnlyWhereNothingStands) {
    Building bridge;
    bridge.parts.push_back({.footprint = test::square({0, 0}, 10), .bottomM = 20, .topM = 30});
    bridge.parts.front().isOverhanging = true;
    City city;
    city.buildings.push_back(std::make_shared<const Building>(bridge));
    EXPECT_TRUE(SnapTargets(city).find({1, 1}, reach10));
    bridge.parts.push_back({.footprint = test::square({40, 0}, 10), .topM = 30});
    city.buildings.front() = std::make_shared<const Building>(bridge);
    EXPECT_FALSE(SnapTargets(city).find({1, 1}, reach10));
    EXPECT_TRUE(SnapTargets(city).find({41, 1}, reach10));
}

TEST(SnapReach, IsThatOfTheViewAroundTheCursor) {
    // A level picture from above: 800 pixels for 2 x 1000 m x tan 20 degrees, north is up.
    const CameraPose above{{0, 0, 0}, 1000, 0, 90};
    const ViewLens lens{40, 1200, 800};
    const double perMetre = 400 / (1000 * std::tan(0.349065850398866));
    const SnapReach reach = computeSnapReach(above, lens, {30, 40, 0});
    EXPECT_NEAR(reach.pixelsPerMetre[0].x, perMetre, 1e-5);
    EXPECT_NEAR(reach.pixelsPerMetre[1].y, -perMetre, 1e-5) << "pixels count from the top";
    EXPECT_NEAR(reach.halfBoxM().x, 10 / perMetre, 1e-4);
    // From 30 degrees above the horizon a metre north is half as long on the screen.
    const CameraPose slanting{{0, 0, 0}, 1000, 0, 30};
    EXPECT_NEAR(computeSnapReach(slanting, lens, {0, 0, 0}).halfBoxM().y, 2 * 10 / perMetre, 1e-3);
    EXPECT_EQ(SnapReach{glm::dmat2(0)}.halfBoxM(), glm::dvec2(500));
}

}  // namespace
}  // namespace noonmark
