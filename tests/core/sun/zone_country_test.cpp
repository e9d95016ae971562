#include "core/sun/zone_country.h"

#include <gtest/gtest.h>

namespace noonmark {
namespace {

TEST(ZoneTowns, TheNearestIsNamedWithItsCountry) {
    const auto town = findNearestZoneTown({4.9, 52.37});
    if (!town) GTEST_SKIP() << "the time zone database is missing";
    EXPECT_EQ(town->name, "Amsterdam");
    EXPECT_EQ(countryName(town->country), "Netherlands");
    EXPECT_LT(town->awayM, 5000);
}

TEST(ZoneTowns, NamesOfSeveralWordsAndSouthernPlacesAreRead) {
    const auto town = findNearestZoneTown({-58.4, -34.6});
    if (!town) GTEST_SKIP() << "the time zone database is missing";
    EXPECT_EQ(town->name, "Buenos Aires");
    EXPECT_EQ(town->country, "AR");
    EXPECT_LT(town->awayM, 20000);
}

}  // namespace
}  // namespace noonmark
