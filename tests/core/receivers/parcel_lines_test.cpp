#include <gmock/gmock.h>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/receivers/parcels/parcel_lines.h"
#include "tests/core/engines/scenes.h"

namespace noonmark {

namespace {

TEST(LineBelts, LieBetweenLinesAroundAParcel) {
    const Footprint parcel{{{0, 0}, {10, 0}, {10, 10}, {0, 10}}, {}};
    const auto belt = cutBelt({parcel}, 5, 10);
    ASSERT_TRUE(belt);
    ASSERT_EQ(belt->size(), 1);
    // Four strips of 10 x 5 m, and a quarter of a ring at each corner.
    const double exact = 4 * 10 * 5 + std::numbers::pi * (10 * 10 - 5 * 5);
    EXPECT_NEAR(area(belt->front()), exact, 0.005 * exact);
    EXPECT_FALSE(contains(belt->front(), {5, -4.9}));
    EXPECT_TRUE(contains(belt->front(), {5, -5.1}));
    EXPECT_TRUE(contains(belt->front(), {5, 19.9}));
    EXPECT_FALSE(contains(belt->front(), {5, 20.1}));
    EXPECT_TRUE(contains(belt->front(), {-5.1, -5.1}));   // 7.2 m from the corner
    EXPECT_FALSE(contains(belt->front(), {-7.2, -7.2}));  // 10.2 m
}

TEST(LineBelts, SurroundParcelsThatTouch) {
    const Footprint west{{{0, 0}, {10, 0}, {10, 10}, {0, 10}}, {}};
    const Footprint east{{{10, 0}, {20, 0}, {20, 10}, {10, 10}}, {}};
    const auto belt = cutBelt({west, east}, 0, 1);
    ASSERT_TRUE(belt);
    double sum = 0;
    for (const Footprint& polygon : *belt) sum += area(polygon);
    EXPECT_NEAR(sum, 60 + std::numbers::pi, 0.05);
}

const Footprint parcel{{{0, 0}, {10, 0}, {10, 20}, {0, 20}}, {}};

// How far a place is outside of the parcel's box.
double distanceOf(glm::vec3 place) {
    const double dx = std::max({0.0, -double(place.x), double(place.x) - 10});
    const double dy = std::max({0.0, -double(place.y), double(place.y) - 20});
    return std::hypot(dx, dy);
}

Result<PointReceivers> placed(const LineSettings& lines, Warnings& warnings, const City& city = {}) {
    return placeOnLines(city, {parcel}, lines, 4, warnings);
}

TEST(LinePoints, LieAtTheirDistancesFromTheParcel) {
    Warnings warnings;
    const PointReceivers points = placed({{5, 10}, 1}, warnings).value();
    // The parcel's 60 m, and a full circle at its corners.
    const double five = 60 + 2 * std::numbers::pi * 5, ten = 60 + 2 * std::numbers::pi * 10;
    std::size_t near = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const bool isFirst = points.elements[i].id.starts_with("5 m, ");
        near += isFirst ? 1 : 0;
        const double offset = isFirst ? 5 : 10;
        EXPECT_NEAR(distanceOf(points.points.positions[i]), offset, 0.004 * offset);
        EXPECT_EQ(points.points.normals[i], glm::vec3(0, 0, 1));
        EXPECT_FLOAT_EQ(points.points.positions[i].z, 4);
    }
    EXPECT_NEAR(double(near), five, 1);
    EXPECT_NEAR(double(points.size() - near), ten, 1);
    EXPECT_TRUE(warnings.empty());
}

TEST(LinePoints, AreEquallySpaced) {
    Warnings warnings;
    const PointReceivers points = placed({{5}, 3}, warnings).value();
    const double length = 60 + 2 * std::numbers::pi * 5;
    EXPECT_EQ(points.size(), std::size_t(std::lround(length / 3)));
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
        const double gap = glm::distance(points.points.positions[i], points.points.positions[i + 1]);
        EXPECT_LT(gap, 3.06);
        EXPECT_GT(gap, 2.7) << "a chord of the corner at most";
    }
}

TEST(LinePoints, InsideABuildingAreLeftOutWithAWarning) {
    const City city = tests::cityOf({{{12, 0, 0}, {18, 20, 9}}});
    Warnings warnings;
    const PointReceivers points = placed({{5}, 1}, warnings, city).value();
    ASSERT_EQ(warnings.size(), 1U);
    EXPECT_THAT(warnings[0].where, testing::HasSubstr("points of the lines"));
    for (const glm::vec3 place : points.points.positions)
        EXPECT_FALSE(place.x > 12.01F && place.y > 0.01F && place.y < 19.99F);
}

TEST(LinePoints, RefuseSettingsOutOfRange) {
    Warnings warnings;
    for (const LineSettings& lines :
         {LineSettings{{}, 1}, {{0}, 1}, {{-5}, 1}, {{5, 501}, 1}, {{5}, 0}, {{5}, 200}, {{std::nan("")}, 1}})
        EXPECT_FALSE(placed(lines, warnings));
}

using testing::HasSubstr;

// Japan: half the width of a road of at most 10 m, else to 5 m inside its far side.
constexpr RoadShift japan{10, 0.5, 5};
const Footprint lot{{{0, 0}, {20, 0}, {20, 30}, {0, 30}}, {}};

Footprint moved(const Footprint& parcel, const std::vector<RoadFront>& roads) {
    const auto polygons = moveLineOut(parcel, roads, japan);
    EXPECT_TRUE(polygons);
    EXPECT_EQ(polygons->size(), 1U);
    return polygons->front();
}

TEST(ParcelRoads, NarrowRoadsCountHalfAndWideOnesAllButTheRest) {
    EXPECT_EQ(shiftOf(japan, 8), 4);
    EXPECT_EQ(shiftOf(japan, 10), 5);
    EXPECT_EQ(shiftOf(japan, 12), 7);
}

TEST(ParcelRoads, AStripIsAddedAlongTheRoad) {
    const Footprint south = moved(lot, {{ParcelSide::south, 8}});
    EXPECT_NEAR(area(south), 20 * 30 + 20 * 4, 1e-3);
    EXPECT_EQ(bounds(south).low.y, -4);
    // The 5 m line is 9 m from the lot there, and 5 m elsewhere.
    const auto belt = cutBelt({south}, 0, 5);
    ASSERT_TRUE(belt);
    EXPECT_TRUE(contains(belt->front(), {10, -8.9}));
    EXPECT_FALSE(contains(belt->front(), {10, -9.1}));
    EXPECT_FALSE(contains(belt->front(), {10, 35.1}));
}

TEST(ParcelRoads, AtACornerBothLinesRunOnUntilTheyMeet) {
    const Footprint corner = moved(lot, {{ParcelSide::south, 8}, {ParcelSide::east, 12}});
    EXPECT_NEAR(area(corner), 20 * 30 + 20 * 4 + 30 * 7 + 4 * 7, 1e-3);
    EXPECT_TRUE(contains(corner, {26.9, -3.9}));
}

TEST(ParcelRoads, EdgesBelongToTheSideTheyFace) {
    // A quarter of the edges of a polygon of 48 edges faces within 45 degrees of south.
    constexpr int edges = 48;
    const auto around = [](double radius) {
        Footprint circle;
        for (int i = 0; i < edges; ++i) {
            const double angle = 2 * std::numbers::pi * i / edges;
            circle.outer.emplace_back(float(radius * std::cos(angle)), float(radius * std::sin(angle)));
        }
        return circle;
    };
    const Footprint parcel = around(20);
    std::vector<RoadFront> all;
    for (const ParcelSide side : parcelSides) all.push_back({side, 8});
    // Moved out on all sides, it is the same polygon with an apothem that is 4 m longer.
    const double apothem = 20 * std::cos(std::numbers::pi / edges);
    EXPECT_NEAR(area(moved(parcel, all)),
                edges * std::tan(std::numbers::pi / edges) * (apothem + 4) * (apothem + 4), 0.05);
    const double strip = area(moved(parcel, {{ParcelSide::south, 8}})) - area(parcel);
    const double ring = area(moved(parcel, all)) - area(parcel);
    EXPECT_NEAR(strip, ring / 4, ring / edges);
}

TEST(ParcelRoads, EdgesBehindTheOthersAreOnNoRoad) {
    // An L: of the edges that face north only the end of the stem is on the road, of those that face east
    // only the end of the foot; the others have a neighbour before them.
    const Footprint angle{{{0, 0}, {30, 0}, {30, 10}, {10, 10}, {10, 30}, {0, 30}}, {}};
    const Footprint out = moved(angle, {{ParcelSide::north, 8}, {ParcelSide::east, 8}});
    EXPECT_NEAR(area(out), 500 + 10 * 4 + 10 * 4, 1e-3);
    // Half a metre of setback is drawing, not a neighbour.
    const Footprint notched{{{0, 0}, {20, 0}, {20, 30}, {10, 30}, {10, 29.5F}, {0, 29.5F}}, {}};
    EXPECT_NEAR(area(moved(notched, {{ParcelSide::north, 8}})), 20 * 30 - 5 + 20 * 4, 1e-3);
}

// A square of 20 m whose south-eastern corner is cut off at 45 degrees, 5 m from it.
const Footprint cut{{{0, 0}, {15, 0}, {20, 5}, {20, 20}, {0, 20}}, {}};

TEST(ParcelRoads, ACutCornerMovesByTheNarrowerOfItsRoads) {
    // 8 m: 4 m out; 16 m: 11 m out. The cut is as near to either: it moves by 4 m.
    const RoadFront south{ParcelSide::south, 8}, east{ParcelSide::east, 16};
    const Footprint one = moved(cut, {south, east}), other = moved(cut, {east, south});
    EXPECT_EQ(one, other) << "whatever comes first";
    EXPECT_TRUE(contains(one, {18, 2}) && contains(one, {19.9F, -0.2F}));
    EXPECT_FALSE(contains(one, {21.5F, -2}));
    EXPECT_TRUE(contains(one, {30.9F, 10}));
    // 387.5 m2 of lot; strips of 15 x 4 and 15 x 11; along the cut, which is 7.07 m long, 4 m; at its
    // southern end a kite of two right triangles with legs of 4 m and 4 tan(22.5 deg); at its eastern end the
    // 4 m line meets the square end of the 11 m strip 4 / cos(45 deg) from the corner: a triangle of 4 x 4.
    const double half = std::tan(std::numbers::pi / 8);
    EXPECT_NEAR(area(one), 387.5 + 15 * 4 + 15 * 11 + 5 * std::numbers::sqrt2 * 4 + 16 * half + 8, 0.01);
}

TEST(ParcelRoads, WithoutRoadsTheLineStays) {
    EXPECT_EQ(moved(lot, {}), lot);
    EXPECT_EQ(moveLineOut(lot, {{ParcelSide::south, 3}}, {10, 0, 5})->size(), 1U) << "a share of 0";
}

TEST(ParcelRoads, AreWrittenAsTheyAreRead) {
    const std::vector<RoadFront> roads{{ParcelSide::south, 8}, {ParcelSide::northeast, 12.5}};
    EXPECT_EQ(formatText(roads), "south=8, northeast=12.5");
    EXPECT_EQ(parseRoads(formatText(roads)).value(), roads);
    EXPECT_EQ(parseRoads(" South = 8 ,NORTHEAST=12.5 ").value(), roads);
    EXPECT_TRUE(parseRoads("").value().empty());
}

TEST(ParcelRoads, WhatMakesNoSenseIsRefused) {
    for (const char* text : {"up=8", "=8", "south 8", ",", "south=8,"})
        EXPECT_THAT(parseRoads(text).error().text(), HasSubstr("no side")) << text;
    for (const char* text : {"south", "south=", "south=8m", "south=0", "south=nan", "south=1e9", "south=-8"})
        EXPECT_THAT(parseRoads(text).error().text(), HasSubstr("no width")) << text;
    EXPECT_THAT(parseRoads("south=8,south=9").error().text(), HasSubstr("Two roads"));
}

}  // namespace

}  // namespace noonmark
