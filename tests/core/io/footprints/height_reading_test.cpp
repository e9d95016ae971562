#include "core/io/heights/height_reading.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace noonmark {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using enum FieldRole;

FeatureValue value(FieldRole role, std::string text, std::string field = "field") {
    return {role, std::move(field), std::move(text), {}, LengthUnit::metres};
}

class HeightReadingTest : public testing::Test {
protected:
    HeightReading read(const FeatureValues& values, bool canopy = false) {
        warnings.clear();
        return readHeights(values, {}, canopy, "way 7", warnings);
    }
    Warnings warnings;
};

TEST_F(HeightReadingTest, TakesTheHeightBeforeTheStoreys) {
    const auto reading = read({value(height, "86m"), value(levels, "10")});
    EXPECT_DOUBLE_EQ(reading.topM, 86);
    EXPECT_EQ(reading.source, HeightSource::measured);
    EXPECT_TRUE(warnings.empty());
}

TEST_F(HeightReadingTest, StoreysAndRoofMakeAHeight) {
    EXPECT_DOUBLE_EQ(read({value(levels, "10")}).topM, 32);
    EXPECT_DOUBLE_EQ(read({value(levels, "10"), value(roofHeight, "4")}).topM, 36);
    EXPECT_DOUBLE_EQ(read({value(levels, "10"), value(roofLevels, "2")}).topM, 38.4);
    EXPECT_EQ(read({value(levels, "10")}).source, HeightSource::levels);
}

TEST_F(HeightReadingTest, ElseTheDefaultWhichIsMarked) {
    const auto reading = read({});
    EXPECT_DOUBLE_EQ(reading.topM, 9.6);
    EXPECT_EQ(reading.source, HeightSource::assumed);
    EXPECT_TRUE(reading.byDefault);
}

TEST_F(HeightReadingTest, NumbersTakeTheirFieldsUnit) {
    FeatureValue feet{height, "HEIGHTROOF", "100", 100.0, LengthUnit::feet};
    EXPECT_DOUBLE_EQ(read({feet}).topM, 30.48);
}

TEST_F(HeightReadingTest, OfAListOfThePartsOfABuildingTheHighestCounts) {
    EXPECT_DOUBLE_EQ(read({value(height, "(3:9.5,20.9,11)", "measuredHeight")}).topM, 20.9);
    ASSERT_EQ(warnings.size(), 1U);
    EXPECT_THAT(warnings[0].what, HasSubstr("the highest is used"));
    EXPECT_DOUBLE_EQ(read({value(height, "(9:9.5,20.9,11,3", "measuredHeight")}).topM, 20.9) << "cut off";
    EXPECT_DOUBLE_EQ(read({value(levels, "(2:2,4)")}).topM, 12.8);
    EXPECT_EQ(read({value(height, "(2:a,b)")}).source, HeightSource::assumed);
    EXPECT_EQ(read({value(height, "(a:1,2)")}).source, HeightSource::assumed);
}

TEST_F(HeightReadingTest, UnreadableTextIsReportedWithFeatureFieldAndText) {
    const auto reading =
        read({value(height, "237;16", "height"), value(levels, "concrete", "building:levels")});
    EXPECT_DOUBLE_EQ(reading.topM, 9.6);
    ASSERT_EQ(warnings.size(), 2U);
    EXPECT_EQ(warnings[0].where, "way 7: building:levels = \"concrete\"");
    EXPECT_EQ(warnings[1].where, "way 7: height = \"237;16\"");
}

TEST_F(HeightReadingTest, ABadHeightGivesWayToTheNextField) {
    EXPECT_DOUBLE_EQ(read({value(height, "unknown"), value(height, "20")}).topM, 20);
    EXPECT_EQ(warnings.size(), 1U);
}

TEST_F(HeightReadingTest, ZeroNegativeAndAbsurdHeightsAreNone) {
    for (const char* text : {"0", "-1", "5000", "0.00001"}) {
        EXPECT_DOUBLE_EQ(read({value(height, text), value(levels, "2")}).topM, 6.4) << text;
        ASSERT_EQ(warnings.size(), 1U) << text;
        EXPECT_THAT(warnings[0].what, HasSubstr("zero or less"));
    }
}

TEST_F(HeightReadingTest, StoreysThatAreNotReadAreReportedEvenBesideAHeight) {
    EXPECT_DOUBLE_EQ(read({value(height, "20"), value(levels, "concrete")}).topM, 20);
    EXPECT_EQ(warnings.size(), 1U);
}

TEST_F(HeightReadingTest, MinHeightLifts) {
    EXPECT_DOUBLE_EQ(read({value(height, "20"), value(minHeight, "5")}).bottomM, 5);
    EXPECT_DOUBLE_EQ(read({value(height, "20"), value(minLevel, "2")}).bottomM, 6.4);
    EXPECT_DOUBLE_EQ(read({value(height, "20"), value(minHeight, "5;5.5"), value(minLevel, "2")}).bottomM,
                     6.4);
    EXPECT_EQ(warnings.size(), 1U);
}

TEST_F(HeightReadingTest, AnUndersideAboveTheTopIsReported) {
    const auto measured = read({value(height, "48"), value(minHeight, "51")});
    EXPECT_DOUBLE_EQ(measured.bottomM, 0);
    EXPECT_DOUBLE_EQ(measured.topM, 48);
    EXPECT_EQ(warnings.size(), 1U);
    const auto guessed = read({value(levels, "2"), value(minHeight, "20")});
    EXPECT_DOUBLE_EQ(guessed.bottomM, 20);
    EXPECT_DOUBLE_EQ(guessed.topM, 26.4);
    EXPECT_EQ(warnings.size(), 1U);
}

// On high ground, top and underside would be equal in float32.
TEST_F(HeightReadingTest, HardlyAnyHeightIsNone) {
    EXPECT_DOUBLE_EQ(read({value(height, "20"), value(minHeight, "19.9999999")}).bottomM, 0);
    EXPECT_DOUBLE_EQ(read({value(height, "20"), value(minHeight, "0.0000001")}).bottomM, 0);
    EXPECT_DOUBLE_EQ(read({value(levels, "0.0000001")}).topM, 9.6);
    EXPECT_DOUBLE_EQ(read({value(groundElevation, "20"), value(topElevation, "20.0000001")}).topM, 9.6);
}

TEST_F(HeightReadingTest, MinHeightBelowTheGroundIsLeftOutAndReported) {
    EXPECT_DOUBLE_EQ(read({value(height, "20"), value(minHeight, "-3")}).bottomM, 0);
    EXPECT_EQ(warnings.size(), 1U);
}

TEST_F(HeightReadingTest, GroundMustBeOnEarth) {
    EXPECT_EQ(read({value(groundElevation, "12.5"), value(height, "9")}).groundElevationM, 12.5);
    EXPECT_EQ(read({value(groundElevation, "-99999"), value(height, "9")}).groundElevationM, std::nullopt);
    EXPECT_EQ(warnings.size(), 1U);
}

TEST_F(HeightReadingTest, ACanopyIsASlabUnderItsTop) {
    const auto slab = read({value(height, "5")}, true);
    EXPECT_DOUBLE_EQ(slab.bottomM, 4.5);
    EXPECT_TRUE(slab.slab);
    EXPECT_DOUBLE_EQ(read({value(height, "0.4")}, true).bottomM, 0.2);
    EXPECT_FALSE(read({value(height, "5"), value(minHeight, "4")}, true).slab);
}

}  // namespace
}  // namespace noonmark
