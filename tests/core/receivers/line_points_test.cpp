#include "core/receivers/parcels/parcel_lines.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/core/engines/scenes.h"

namespace noonmark {
namespace {

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

}  // namespace
}  // namespace noonmark
