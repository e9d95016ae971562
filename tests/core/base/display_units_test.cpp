#include "core/base/units.h"

#include <gtest/gtest.h>

namespace noonmark::tests {
namespace {

TEST(DisplayUnits, LengthsAreInMetresFeetOrBoth) {
    // 100 m / 0.3048 m = 328.0840 ft
    EXPECT_EQ(formatLength(100, UnitSystem::metric), "100.0 m");
    EXPECT_EQ(formatLength(100, UnitSystem::imperial), "328.1 ft");
    EXPECT_EQ(formatLength(100, UnitSystem::both, 0), "100 m (328 ft)");
    EXPECT_EQ(formatLength(-1234.56, UnitSystem::metric), "-1,234.6 m");
}

TEST(DisplayUnits, AreasChangeToHectaresAndAcresFromTenOn) {
    // 1 sq ft = 0.09290304 m2; 10 acres = 435,600 sq ft = 40,468.56 m2
    EXPECT_EQ(formatArea(1000, UnitSystem::metric), "1,000 m²");
    EXPECT_EQ(formatArea(1000, UnitSystem::imperial), "10,764 sq ft");
    EXPECT_EQ(formatArea(99999, UnitSystem::metric), "99,999 m²");
    EXPECT_EQ(formatArea(100000, UnitSystem::metric), "10.0 ha");
    EXPECT_EQ(formatArea(40468, UnitSystem::imperial), "435,594 sq ft");
    EXPECT_EQ(formatArea(40469, UnitSystem::imperial), "10.0 acres");
}

TEST(DisplayUnits, AreaHoursAreNeverInHectares) {
    EXPECT_EQ(formatAreaHours(1e6, UnitSystem::metric), "1,000,000 m² h");
    EXPECT_EQ(formatAreaHours(0.09290304 * 1e6, UnitSystem::imperial), "1,000,000 sq ft h");
}

TEST(DisplayUnits, NamesAreReadBack) {
    for (const UnitSystem units : unitSystems) EXPECT_EQ(parseUnitSystem(nameOf(units)), units);
    EXPECT_FALSE(parseUnitSystem("furlongs"));
}

}  // namespace
}  // namespace noonmark::tests
