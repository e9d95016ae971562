#include "scenarios/massing/lot_edits.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace noonmark {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

// 40 m east by 20 m north; edge 0 is the south side, edge 2 the north side.
const Footprint oblong{{{0, 0}, {40, 0}, {40, 20}, {0, 20}}, {}};

TEST(LotShape, ASideOfARectangleMovesAloneAndTheSidesBesideItGrow) {
    const auto moved = moveEdge(oblong, 2, 5);
    ASSERT_TRUE(moved) << moved.error().text();
    EXPECT_NEAR(area(*moved), 40 * 25, 1e-3);
    EXPECT_EQ(bounds(*moved), (Box2{{0, 0}, {40, 25}}));
    const auto inwards = moveEdge(oblong, 1, -15);
    ASSERT_TRUE(inwards);
    EXPECT_EQ(bounds(*inwards), (Box2{{0, 0}, {25, 20}}));
}

// The sides beside the top lean inwards by 1 in 2: from (0, 0) to (10, 20), from (60, 0) to (50, 20). 10 m
// further up the top reaches from x = 15 to x = 45; 10 m further down from 5 to 55.
TEST(LotShape, ASideOfATrapezoidKeepsTheDirectionsBesideIt) {
    const Footprint trapezoid{{{0, 0}, {60, 0}, {50, 20}, {10, 20}}, {}};
    const auto up = moveEdge(trapezoid, 2, 10);
    ASSERT_TRUE(up);
    EXPECT_NEAR(area(*up), (60 + 30) / 2.0 * 30, 1e-2);
    EXPECT_THAT(up->outer, testing::UnorderedElementsAre(glm::vec2(0, 0), glm::vec2(60, 0), glm::vec2(45, 30),
                                                         glm::vec2(15, 30)));
    const auto down = moveEdge(trapezoid, 2, -10);
    ASSERT_TRUE(down);
    EXPECT_THAT(down->outer, testing::UnorderedElementsAre(glm::vec2(0, 0), glm::vec2(60, 0),
                                                           glm::vec2(55, 10), glm::vec2(5, 10)));
}

// The sides beside the top meet at height 60.
TEST(LotShape, ASideThatMovesBeyondWhereItsNeighboursMeetIsRefused) {
    const Footprint trapezoid{{{0, 0}, {60, 0}, {50, 20}, {10, 20}}, {}};
    EXPECT_TRUE(moveEdge(trapezoid, 2, 39));
    const auto beyond = moveEdge(trapezoid, 2, 41);
    ASSERT_FALSE(beyond);
    EXPECT_THAT(beyond.error().what, HasSubstr("meet before that"));
}

// A corner in the middle of the south side: its eastern half moves 8 m out, and a step joins the halves.
TEST(LotShape, AHalfOfAStraightSideMovesOutWithAStep) {
    const auto split = insertCorner(oblong, 0);
    ASSERT_TRUE(split);
    EXPECT_THAT(split->outer, ElementsAre(glm::vec2(0, 0), glm::vec2(20, 0), glm::vec2(40, 0),
                                          glm::vec2(40, 20), glm::vec2(0, 20)));
    const auto stepped = moveEdge(*split, 1, 8);
    ASSERT_TRUE(stepped) << stepped.error().text();
    EXPECT_NEAR(area(*stepped), 40 * 20 + 20 * 8, 1e-3);
    EXPECT_EQ(stepped->outer.size(), 6U);
}

TEST(LotShape, ACornerMovesAlone) {
    const auto moved = moveCorner(oblong, 2, {50, 30});
    ASSERT_TRUE(moved);
    EXPECT_THAT(moved->outer,
                ElementsAre(glm::vec2(0, 0), glm::vec2(40, 0), glm::vec2(50, 30), glm::vec2(0, 20)));
}

TEST(LotShape, SidesThatCrossOrTouchAreRefused) {
    const auto bowTie = moveCorner(oblong, 2, {20, -10});
    ASSERT_FALSE(bowTie);
    EXPECT_THAT(bowTie.error().what, HasSubstr("cross or touch"));
    EXPECT_FALSE(moveCorner(oblong, 2, {20, 0})) << "a corner on the opposite side";
    EXPECT_FALSE(moveEdge(oblong, 2, -20)) << "nothing is left";
}

TEST(LotShape, ALotThatIsTurnedInsideOutStaysCounterClockwise) {
    const auto flat = moveEdge(oblong, 2, -50);
    ASSERT_TRUE(flat);
    EXPECT_NEAR(signedArea(flat->outer), 40 * 30, 1e-3);
    EXPECT_EQ(bounds(*flat), (Box2{{0, -30}, {40, 0}}));
}

TEST(LotShape, HolesStayAndMustStayInside) {
    Footprint lot = oblong;
    lot.holes.push_back({{10, 5}, {10, 15}, {20, 15}, {20, 5}});
    const auto wider = moveEdge(lot, 1, 10);
    ASSERT_TRUE(wider) << wider.error().text();
    EXPECT_EQ(wider->holes, lot.holes);
    EXPECT_FALSE(moveEdge(lot, 1, -25)) << "the side would cut the hole";
}

TEST(LotShape, ThreeCornersRemain) {
    const auto triangle = removeCorner(oblong, 1);
    ASSERT_TRUE(triangle);
    EXPECT_THAT(triangle->outer, ElementsAre(glm::vec2(0, 0), glm::vec2(40, 20), glm::vec2(0, 20)));
    const auto line = removeCorner(*triangle, 0);
    ASSERT_FALSE(line);
    EXPECT_THAT(line.error().what, HasSubstr("three corners"));
}

TEST(LotShape, OutwardIsAcrossTheSideAndOutOfTheLot) {
    EXPECT_EQ(outwardOf(oblong, 0), glm::dvec2(0, -1));
    EXPECT_EQ(outwardOf(oblong, 1), glm::dvec2(1, 0));
    EXPECT_EQ(outwardOf(oblong, 3), glm::dvec2(-1, 0));
}

}  // namespace
}  // namespace noonmark
