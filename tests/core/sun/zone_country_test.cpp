#include <gtest/gtest.h>

#include "core/sun/zone_country.h"

namespace noonmark {

namespace {

TEST(ZoneTowns, TheNearestIsNamedWithItsCountry) {
    const auto town = findNearestZoneTown({4.9, 52.37});
    if (!town) GTEST_SKIP() << "the time zone database is missing";
    EXPECT_EQ(town->name, "Amsterdam");
    EXPECT_EQ(countryName(town->country), "Netherlands");
    EXPECT_LT(town->distanceM, 5000);
}

TEST(ZoneTowns, NamesOfSeveralWordsAndSouthernPlacesAreRead) {
    const auto town = findNearestZoneTown({-58.4, -34.6});
    if (!town) GTEST_SKIP() << "the time zone database is missing";
    EXPECT_EQ(town->name, "Buenos Aires");
    EXPECT_EQ(town->country, "AR");
    EXPECT_LT(town->distanceM, 20000);
}

bool isQuestioned(const char* zone, LonLat place) {
    Period period;
    period.zone = zone;
    return questionZone(period, place).has_value();
}

TEST(ZoneQuestion, AZoneOfAnotherContinentIsQuestioned) {
    EXPECT_TRUE(isQuestioned("America/New_York", {14.4, 50.1}));
    EXPECT_TRUE(isQuestioned("Europe/Prague", {-73.98, 40.76}));
    EXPECT_TRUE(isQuestioned("Asia/Tokyo", {55.3, 25.2}));
}

TEST(ZoneQuestion, TheWidestZonesOfTheWorldAreNot) {
    EXPECT_FALSE(isQuestioned("America/New_York", {-73.98, 40.76}));
    EXPECT_FALSE(isQuestioned("Asia/Shanghai", {73.6, 39.5})) << "the west of China";
    EXPECT_FALSE(isQuestioned("Europe/Madrid", {-9.2, 43.0}));
    EXPECT_FALSE(isQuestioned("Pacific/Kiritimati", {-157.4, 1.9})) << "UTC+14";
    EXPECT_FALSE(isQuestioned("Pacific/Auckland", {-176.5, -44.0})) << "across 180 degrees";
}

TEST(ZoneQuestion, UtcAndUnknownZonesAreNobodysMistake) {
    EXPECT_FALSE(isQuestioned("UTC", {139.7, 35.7}));
    EXPECT_FALSE(isQuestioned("Etc/GMT+5", {139.7, 35.7}));
    EXPECT_FALSE(isQuestioned("Nowhere/Here", {139.7, 35.7}));
}

}  // namespace

}  // namespace noonmark
