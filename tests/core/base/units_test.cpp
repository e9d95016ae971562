#include <gtest/gtest.h>

#include "core/base/units.h"

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

double metric(std::string_view text) { return parseLength(text, UnitSystem::metric).value_or(-1e9); }
double imperial(std::string_view text) { return parseLength(text, UnitSystem::imperial).value_or(-1e9); }

// 12.5 ft = 12.5 x 0.3048 m = 3.81 m
TEST(LengthText, FeetAndInchesAreReadAsTheyAreWritten) {
    for (const char* text :
         {"12' 6\"", "12'6\"", "12' 6", "12'-6\"", "12 ft 6 in", "12 feet 6 inches", "12.5'", "150\"",
          "12\u2032 6\u2033", "12\u2019 6\u201d", " 12,5 ft ", "12' 6''"})
        EXPECT_NEAR(metric(text), 3.81, 1e-12) << text;
    EXPECT_NEAR(metric("12' 6 1/2\""), 3.81 + 0.0127, 1e-12);
    EXPECT_NEAR(metric("1/2\""), 0.0127, 1e-12);
    EXPECT_NEAR(metric("-12' 6\""), -3.81, 1e-12) << "the sign is of the whole";
}

TEST(LengthText, ANumberAloneIsInTheUnitsInUse) {
    EXPECT_NEAR(metric("12.5"), 12.5, 1e-12);
    EXPECT_NEAR(imperial("12.5"), 3.81, 1e-12);
    EXPECT_NEAR(imperial("3.5 m"), 3.5, 1e-12) << "a unit overrules them";
    EXPECT_NEAR(imperial("350cm"), 3.5, 1e-12);
    EXPECT_NEAR(metric("3500 mm"), 3.5, 1e-12);
}

TEST(LengthText, OtherTextsAreRefused) {
    for (const char* text : {"", "m", "3 miles", "3 m 4", "3..4", "6\" 2'", "1/0\"", "--3", "1e5", "nan",
                             "99999999999", "12' 6\" 3"})
        EXPECT_FALSE(parseLength(text, UnitSystem::metric)) << text;
}

TEST(LengthText, WhatIsWrittenIsReadAgain) {
    EXPECT_EQ(formatFeetAndInches(3.81), "12' 6\"");
    EXPECT_EQ(formatFeetAndInches(0), "0' 0\"");
    EXPECT_EQ(formatFeetAndInches(0.3048 * 5 - 1e-6), "5' 0\"") << "never 4' 12\"";
    EXPECT_EQ(formatFeetAndInches(-0.08255), "-0' 3.25\"");
    for (double metres = -20; metres < 20; metres += 0.37)
        EXPECT_NEAR(metric(formatFeetAndInches(metres)), metres, 0.0254 / 200 + 1e-9);
}

}  // namespace

}  // namespace noonmark::tests
