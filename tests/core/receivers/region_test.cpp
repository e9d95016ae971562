#include "core/receivers/region.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "core/study/text/region_text.h"

namespace noonmark {
namespace {

TEST(Region, LonLatBoxFollowsTheParallels) {
    const Frame frame({-73.98, 40.75});
    const auto region = makeRegionFromLonLatBox(frame, -74.0, 40.74, -73.96, 40.76);
    ASSERT_TRUE(region.has_value());
    ASSERT_EQ(region->polygons.size(), 1U);
    const Footprint& polygon = region->polygons[0];
    EXPECT_GT(signedArea(polygon.outer), 0);
    // Known lengths at 40.75 N: 111,049 m per degree of latitude, 84,443 m per degree of longitude.
    EXPECT_NEAR(area(polygon), 0.02 * 111049 * 0.04 * 84443, 0.02 * 111049 * 0.04 * 84443 * 1e-3);
    EXPECT_TRUE(contains(polygon, {0, 0}));
    for (const glm::vec2 point : polygon.outer) {
        const LonLat place = frame.lonLatFromLocal(glm::dvec2(point));
        const bool onMeridian = std::abs(std::abs(place.lonDeg + 73.98) - 0.02) < 1e-7;
        const bool onParallel = std::abs(std::abs(place.latDeg - 40.75) - 0.01) < 1e-7;
        EXPECT_TRUE(onMeridian || onParallel) << place.lonDeg << ' ' << place.latDeg;
    }
}

// Taveuni, Fiji: the 180th meridian runs through its middle.
TEST(Region, ABoxMayLieAcrossTheAntimeridian) {
    const Frame taveuni({180, -16.85});
    const Region across = makeRegionFromLonLatBox(taveuni, 179.98, -16.86, -179.97, -16.84).value();
    const Frame samePlace({10, -16.85});
    const Region elsewhere = makeRegionFromLonLatBox(samePlace, 9.98, -16.86, 10.03, -16.84).value();
    ASSERT_EQ(across.polygons[0].outer.size(), elsewhere.polygons[0].outer.size());
    for (std::size_t i = 0; i < across.polygons[0].outer.size(); ++i)
        EXPECT_NEAR(glm::distance(across.polygons[0].outer[i], elsewhere.polygons[0].outer[i]), 0, 1e-3);
    EXPECT_EQ(formatBox(across, taveuni), "179.98,-16.86,-179.97,-16.84");
    EXPECT_EQ(formatBox(elsewhere, samePlace), "9.98,-16.86,10.03,-16.84");
    const Region toIt = makeRegionFromLonLatBox(taveuni, 179.98, -16.86, 180, -16.84).value();
    EXPECT_EQ(formatBox(toIt, taveuni), "179.98,-16.86,180,-16.84");
}

TEST(Region, BoxesThatAreNoneAreRefused) {
    const Frame frame({-73.98, 40.75});
    EXPECT_FALSE(makeRegionFromLonLatBox(frame, -73.96, 40.74, -74.0, 40.76).has_value());
    EXPECT_FALSE(makeRegionFromLonLatBox(frame, -74.0, 40.76, -73.96, 40.74).has_value());
    EXPECT_FALSE(makeRegionFromLonLatBox(frame, -74.0, 40.74, -74.0, 40.76).has_value());
    EXPECT_FALSE(makeRegionFromLonLatBox(frame, -74.0, 40.74, -73.96, 90.1).has_value());
    EXPECT_FALSE(makeRegionFromLonLatBox(frame, -181, 40.74, -73.96, 40.76).has_value());
    EXPECT_FALSE(makeRegionFromLonLatBox(frame, std::nan(""), 40.74, -73.96, 40.76).has_value());
}

}  // namespace
}  // namespace noonmark
