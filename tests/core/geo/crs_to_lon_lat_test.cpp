#include "core/geo/crs.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace noonmark {
namespace {

LonLat convert(const std::string& crs, glm::dvec2 point) {
    return CrsToLonLat::of(crs).value().lonLat({&point, 1})[0];
}

TEST(CrsToLonLat, EverySpellingOfTheSameSystem) {
    for (const char* crs :
         {"EPSG:32618", "epsg:32618", "urn:ogc:def:crs:EPSG::32618", "urn:ogc:def:crs:EPSG:9.9:32618",
          "http://www.opengis.net/def/crs/EPSG/0/32618", "https://www.opengis.net/def/crs/EPSG/0/32618/"}) {
        const LonLat place = convert(crs, {500000, 4649776.22});  // the central meridian, 42 degrees north
        EXPECT_NEAR(place.lonDeg, -75, 1e-9) << crs;
        EXPECT_NEAR(place.latDeg, 42, 1e-5) << crs;
    }
}

TEST(CrsToLonLat, LongitudeComesFirst) {
    const LonLat place = convert("EPSG:4326", {-73.98, 40.75});
    EXPECT_NEAR(place.lonDeg, -73.98, 1e-9);
    EXPECT_NEAR(place.latDeg, 40.75, 1e-9);
}

TEST(CrsToLonLat, EastingsLoseTheNumberOfTheirZone) {
    for (const char* crs : {"EPSG:25833", "EPSG:25833+7837", "EPSG:32633"}) {
        const auto system = CrsToLonLat::of(crs);
        const glm::dvec2 plain{391800, 5820000}, numbered{33391800, 5820000};
        const LonLat place = system->lonLat({&plain, 1})[0];
        EXPECT_FALSE(system->tookZoneOff()) << crs;
        const LonLat same = system->lonLat({&numbered, 1})[0];
        EXPECT_TRUE(system->tookZoneOff()) << crs;
        EXPECT_EQ(same.lonDeg, place.lonDeg) << crs;
        EXPECT_EQ(same.latDeg, place.latDeg) << crs;
    }
    // Another zone's number is not taken off, and this system states its numbers itself.
    EXPECT_TRUE(std::isnan(convert("EPSG:25833", {32391800, 5820000}).lonDeg) ||
                !CrsToLonLat::of("EPSG:25833")->isPlausible(convert("EPSG:25833", {32391800, 5820000})));
    const auto own = CrsToLonLat::of("EPSG:4647");
    const glm::dvec2 point{32500000, 5820000};
    EXPECT_NEAR(own->lonLat({&point, 1})[0].lonDeg, 9, 1e-9);
    EXPECT_FALSE(own->tookZoneOff());
}

TEST(CrsToLonLat, UnitsOfHeight) {
    const auto unit = [](const char* crs) {
        const auto made = CrsToLonLat::of(crs);
        return std::pair(made->metresPerElevationUnit(), made->elevationUnitIsStated());
    };
    EXPECT_EQ(unit("EPSG:7415"), std::pair(1.0, true));
    EXPECT_EQ(unit("EPSG:4979"), std::pair(1.0, true));
    EXPECT_EQ(unit("EPSG:28992"), std::pair(1.0, false));
    EXPECT_NEAR(unit("EPSG:2263+6360").first, 1200.0 / 3937, 1e-12);
    EXPECT_TRUE(unit("EPSG:2263+6360").second);
    EXPECT_EQ(unit("EPSG:2263+5703"), std::pair(1.0, true));
    EXPECT_NEAR(unit("EPSG:2263").first, 1200.0 / 3937, 1e-12);
    EXPECT_FALSE(unit("EPSG:2263").second);
}

TEST(CrsToLonLat, WhatIsNoPlaceIsNaN) {
    for (const glm::dvec2 point :
         {glm::dvec2(std::numeric_limits<double>::quiet_NaN(), 0), glm::dvec2(1e30, 1e30),
          glm::dvec2(std::numeric_limits<double>::infinity(), 5)})
        EXPECT_TRUE(std::isnan(convert("EPSG:32618", point).latDeg));
    EXPECT_TRUE(std::isnan(convert("EPSG:4326", {10, 95}).latDeg));
}

TEST(CrsToLonLat, KnowsWhereItIsUsed) {
    const auto dutch = CrsToLonLat::of("EPSG:28992");
    EXPECT_TRUE(dutch->isPlausible({4.9, 52.4}));
    EXPECT_FALSE(dutch->isPlausible({-73.98, 40.75}));
    EXPECT_FALSE(dutch->isPlausible({std::nan(""), std::nan("")}));
    EXPECT_TRUE(CrsToLonLat::of("EPSG:4326")->isPlausible({179, -80}));
    // New Zealand's area of use crosses the date line
    EXPECT_TRUE(CrsToLonLat::of("EPSG:2193")->isPlausible({-179, -40}));
}

TEST(CrsToLonLat, WhatIsNoSystemIsAnError) {
    for (const char* crs : {"", "EPSG:0", "EPSG:999999", "hello", "EPSG:5709", "http://example.com/crs"}) {
        const auto made = CrsToLonLat::of(crs);
        ASSERT_FALSE(made) << crs;
        EXPECT_FALSE(made.error().advice.empty());
    }
}

}  // namespace
}  // namespace noonmark
