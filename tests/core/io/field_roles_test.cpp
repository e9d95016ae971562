#include "core/io/field_roles.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/io/other_tags.h"

namespace noonmark {
namespace {

using testing::ElementsAre;
using testing::Pair;

std::optional<FieldRole> roleOf(std::string_view name, bool cutShort = false) {
    const auto meaning = meaningOf(name, cutShort);
    return meaning ? std::optional(meaning->role) : std::nullopt;
}

TEST(FieldRoles, knowsTheUsualNamesInAnyCase) {
    for (const char* name : {"height", "HEIGHT", "building:height", "measuredHeight", "heightroof",
                             "height_roof", "BldgHeight", "Height (m)"})
        EXPECT_EQ(roleOf(name), FieldRole::height) << name;
    for (const char* name : {"building:levels", "num_floors", "NumFloors", "storeysAboveGround"})
        EXPECT_EQ(roleOf(name), FieldRole::levels) << name;
    EXPECT_EQ(roleOf("min_height"), FieldRole::minHeight);
    EXPECT_EQ(roleOf("building:min_level"), FieldRole::minLevel);
    for (const char* name : {"groundelev", "GROUND_ELEVATION"})
        EXPECT_EQ(roleOf(name), FieldRole::groundElevation) << name;
    EXPECT_EQ(roleOf("roof:height"), FieldRole::roofHeight);
    EXPECT_EQ(roleOf("roof:shape"), FieldRole::roofShape);
}

TEST(FieldRoles, doesNotTakeOtherNamesForHeights) {
    for (const char* name : {"", "weight", "heightened", "max_height_limit", "m", "ft", "levelsm", "area"})
        EXPECT_EQ(roleOf(name), std::nullopt) << name;
}

TEST(FieldRoles, readsTheUnitInAName) {
    EXPECT_EQ(meaningOf("height_ft")->unit, LengthUnit::feet);
    EXPECT_EQ(meaningOf("Height (feet)")->unit, LengthUnit::feet);
    EXPECT_EQ(meaningOf("bldg_height_m")->unit, LengthUnit::metres);
    EXPECT_EQ(meaningOf("height")->unit, std::nullopt);
}

TEST(FieldRoles, knowsNamesCutShortUnlessTheyAreAmbiguous) {
    EXPECT_EQ(roleOf("ground_ele", true), FieldRole::groundElevation);
    EXPECT_EQ(roleOf("measuredHe", true), FieldRole::height);
    EXPECT_EQ(roleOf("building:l", true), FieldRole::levels);
    EXPECT_EQ(roleOf("building:m", true), std::nullopt);
    EXPECT_EQ(roleOf("ground_ele", false), std::nullopt);
    EXPECT_EQ(roleOf("ground", true), std::nullopt);
}

TEST(FieldRoles, theUsersFieldIsTheOnlyHeight) {
    const auto fields = knownFields({"height", "Roof_Top", "num_floors"}, "ROOF_TOP", false);
    ASSERT_EQ(fields.size(), 2U);
    EXPECT_EQ(fields[0].name, "Roof_Top");
    EXPECT_EQ(fields[0].meaning.role, FieldRole::height);
    EXPECT_EQ(fields[1].meaning.role, FieldRole::levels);
}

TEST(FieldRoles, theBetterFieldComesFirst) {
    const auto fields = knownFields({"BLDGHEIGHT", "height"}, "", false);
    ASSERT_EQ(fields.size(), 2U);
    EXPECT_EQ(fields[0].name, "height");
}

class Units : public testing::Test {
protected:
    LengthUnit unitOf(const std::vector<std::string>& names, const UnitRules& rules) {
        warnings.clear();
        auto fields = knownFields(names, "", false);
        settleUnits(fields, rules, "a.shp", warnings);
        return fields.at(0).unit;
    }
    Warnings warnings;
};

TEST_F(Units, areMetresUnlessSaidOtherwise) {
    EXPECT_EQ(unitOf({"height", "ground_elevation"}, {}), LengthUnit::metres);
    EXPECT_TRUE(warnings.empty());
    EXPECT_EQ(unitOf({"height_ft"}, {}), LengthUnit::feet);
    EXPECT_EQ(unitOf({"height_ft"}, {.stated = LengthUnit::metres}), LengthUnit::metres);
    EXPECT_TRUE(warnings.empty());
}

TEST_F(Units, ofNewYorksFieldsAreFeetAndSaid) {
    EXPECT_EQ(unitOf({"HEIGHTROOF", "GROUNDELEV"}, {}), LengthUnit::feet);
    EXPECT_EQ(warnings.size(), 2U);
    EXPECT_EQ(unitOf({"height_roof", "ground_elevation"}, {}), LengthUnit::feet);
    EXPECT_EQ(warnings.size(), 2U);
    EXPECT_EQ(unitOf({"heightroof"}, {}), LengthUnit::metres);
    EXPECT_EQ(warnings.size(), 1U);
    EXPECT_EQ(unitOf({"heightroof", "groundelev"}, {.stated = LengthUnit::metres}), LengthUnit::metres);
    EXPECT_TRUE(warnings.empty());
}

TEST_F(Units, ofAMapInFeetAreNotSilentlyMetres) {
    EXPECT_EQ(unitOf({"height"}, {.mapInFeet = true}), LengthUnit::metres);
    EXPECT_EQ(warnings.size(), 1U);
    EXPECT_EQ(unitOf({"heightroof"}, {.mapInFeet = true}), LengthUnit::feet);
    EXPECT_EQ(warnings.size(), 1U);
}

TEST(OtherTags, areReadAsFarAsTheyGo) {
    EXPECT_THAT(tagsFromText(R"("height"=>"12","name"=>"a \"b\", c")"),
                ElementsAre(Pair("height", "12"), Pair("name", "a \"b\", c")));
    EXPECT_THAT(tagsFromText(R"("height"=>"12",broken)"), ElementsAre(Pair("height", "12")));
    EXPECT_TRUE(tagsFromText("").empty());
    EXPECT_TRUE(tagsFromText("\"").empty());
    EXPECT_TRUE(tagsFromText(R"("a"=>"\)").empty());
}

}  // namespace
}  // namespace noonmark
