#include "core/measures/places/place_screening.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/engines/projected/projected_shadows.h"
#include "tests/core/engines/scenes.h"

namespace noonmark {
namespace {

using namespace tests;
using testing::HasSubstr;

Place parkAt(std::string name, float west, float south) {
    return {std::move(name), PlaceKind::park, {{rectangle(west, south, west + 20, south + 20), {}}}, "drawn"};
}

// The sun goes from east by south to west, at 45 deg: a tower of 50 m casts shadows 50 m long to the west,
// north and east, and none to the south.
const SunSteps halfRound = oneDay({{90, 45}, {135, 45}, {180, 45}, {225, 45}, {270, 45}});

TEST(OutlineDistance, IsThatBetweenTheNearestSides) {
    const std::vector<Footprint> a{{rectangle(0, 0, 10, 10), {}}}, b{{rectangle(13, 14, 20, 20), {}}},
        c{{rectangle(5, 5, 7, 7), {}}}, d{{rectangle(8, -5, 9, 15), {}}};
    EXPECT_DOUBLE_EQ(measureDistanceM(a, b), 5);
    EXPECT_EQ(measureDistanceM(a, c), 0);
    EXPECT_EQ(measureDistanceM(a, d), 0);  // they cross, no corner lies in the other
    EXPECT_TRUE(std::isinf(measureDistanceM(a, {})));
}

TEST(PlaceScreening, TheSunLeavesASectorFreeAndStatesTheLongestShadow) {
    EXPECT_NEAR(findLengthFactor(halfRound), 1, 1e-6);
    const auto sector = findNoShadowSector(halfRound);  // shadows fall from 270 over 0 to 90 deg
    ASSERT_TRUE(sector);
    EXPECT_NEAR(sector->fromDeg, 90.25, 1e-3);
    EXPECT_NEAR(sector->toDeg, 269.75, 1e-3);
    EXPECT_FALSE(findNoShadowSector({}));
}

TEST(PlaceScreening, EachPlaceIsRuledOutByTheFirstTestThatItFails) {
    const City before = cityOf({{{500, 500, 0}, {510, 510, 5}}});
    City after = before;
    after.buildings.push_back(buildingOf({{0, 0, 0}, {10, 10, 50}}));
    const std::vector<Place> places{parkAt("north", -5, 40), parkAt("far", -5, 90), parkAt("south", -5, -35),
                                    parkAt("north-north-east", 28, 32)};
    NoProgress quiet;
    const auto screened =
        screenPlaces(before, after, places, halfRound, {.cellM = 1}, ProjectedShadows(), quiet, {}).value();
    ASSERT_EQ(screened.size(), 4U);
    EXPECT_EQ(screened[0].result, ScreeningResult::reached);
    EXPECT_EQ(screened[0].minutes, 1);  // only the sun due south throws it there
    EXPECT_NEAR(screened[0].distanceM, 30, 1e-6);
    EXPECT_NEAR(screened[0].azimuthDeg, 0, 1);
    EXPECT_EQ(screened[1].result, ScreeningResult::outOfLength);
    EXPECT_THAT(screened[1].reason, HasSubstr("80 m away; the shadow is at most 50 m long"));
    EXPECT_EQ(screened[2].result, ScreeningResult::outOfSector);
    EXPECT_EQ(screened[3].result, ScreeningResult::reached);  // at 225 deg, 35 m to the east and to the north
    const auto byRule = screenPlaces(before, after, places, halfRound,
                                     {.lengthFactor = 4.3, .noShadow = AzimuthSector{108, 252}},
                                     ProjectedShadows(), quiet, {})
                            .value();
    EXPECT_EQ(byRule[1].result, ScreeningResult::notReached);  // 4.3 x 50 m would reach it
    EXPECT_EQ(byRule[2].result, ScreeningResult::outOfSector);
    EXPECT_FALSE(screenPlaces(before, before, places, halfRound, {}, ProjectedShadows(), quiet, {}));
}

}  // namespace
}  // namespace noonmark
