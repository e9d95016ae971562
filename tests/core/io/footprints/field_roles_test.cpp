#include "core/io/heights/field_roles.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/io/footprints/feature_facts.h"

namespace noonmark {
namespace {

using testing::ElementsAre;
using testing::Pair;

std::optional<FieldRole> roleOf(std::string_view name, bool cutShort = false) {
    const auto meaning = findMeaning(name, cutShort);
    return meaning ? std::optional(meaning->role) : std::nullopt;
}

TEST(FieldRoles, KnowsTheUsualNamesInAnyCase) {
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

TEST(FieldRoles, DoesNotTakeOtherNamesForHeights) {
    for (const char* name : {"", "weight", "heightened", "max_height_limit", "m", "ft", "levelsm", "area"})
        EXPECT_EQ(roleOf(name), std::nullopt) << name;
}

TEST(FieldRoles, ReadsTheUnitInAName) {
    EXPECT_EQ(findMeaning("height_ft")->unit, LengthUnit::feet);
    EXPECT_EQ(findMeaning("Height (feet)")->unit, LengthUnit::feet);
    EXPECT_EQ(findMeaning("bldg_height_m")->unit, LengthUnit::metres);
    EXPECT_EQ(findMeaning("height")->unit, std::nullopt);
}

TEST(FieldRoles, KnowsNamesCutShortUnlessTheyAreAmbiguous) {
    EXPECT_EQ(roleOf("ground_ele", true), FieldRole::groundElevation);
    EXPECT_EQ(roleOf("measuredHe", true), FieldRole::height);
    EXPECT_EQ(roleOf("building:l", true), FieldRole::levels);
    EXPECT_EQ(roleOf("building:m", true), std::nullopt);
    EXPECT_EQ(roleOf("ground_ele", false), std::nullopt);
    EXPECT_EQ(roleOf("ground", true), std::nullopt);
}

TEST(FieldRoles, TheUsersFieldIsTheOnlyHeight) {
    const auto fields = knownFields({"height", "Roof_Top", "num_floors"}, {.height = "ROOF_TOP"}, false);
    ASSERT_EQ(fields.size(), 2U);
    EXPECT_EQ(fields[0].name, "Roof_Top");
    EXPECT_EQ(fields[0].meaning.role, FieldRole::height);
    EXPECT_EQ(fields[1].meaning.role, FieldRole::levels);
}

TEST(FieldRoles, TheBetterFieldComesFirst) {
    const auto fields = knownFields({"BLDGHEIGHT", "height"}, {}, false);
    ASSERT_EQ(fields.size(), 2U);
    EXPECT_EQ(fields[0].name, "height");
}

struct Published {
    const char* name;
    FieldRole role;
    std::optional<LengthUnit> unit;
};

// Field names as their producers publish them.
TEST(FieldRoles, KnowsThePublishedDatasets) {
    constexpr auto m = LengthUnit::metres;
    const Published fields[] = {
        {"HAUTEUR", FieldRole::height, m},     // France, BD TOPO
        {"NB_ETAGES", FieldRole::levels, {}},  //
        {"altitude_minimale_sol", FieldRole::groundElevation, m},
        {"altitude_maximale_toit", FieldRole::topElevation, m},
        {"RELHMAX", FieldRole::height, m},  // Great Britain
        {"RelH2", FieldRole::height, m},
        {"AbsHMin", FieldRole::groundElevation, m},
        {"AbsHMax", FieldRole::topElevation, m},
        {"h_dak_max", FieldRole::topElevation, m},  // Netherlands
        {"b3_h_dak_50p", FieldRole::topElevation, m},
        {"b3_h_dak_70p", FieldRole::topElevation, m},
        {"b3_h_maaiveld", FieldRole::groundElevation, m},
        {"HOEHE", FieldRole::height, {}},  // Germany, Switzerland, Austria
        {"Hoehe_m", FieldRole::height, m},
        {"HoeheDach", FieldRole::topElevation, m},
        {"HoeheGrund", FieldRole::groundElevation, m},
        {"AnzahlGeschosse", FieldRole::levels, {}},
        {"GASTW", FieldRole::levels, {}},
        {"DACH_MAX", FieldRole::topElevation, m},
        {"GELAENDEPUNKT", FieldRole::groundElevation, m},
        {"altura", FieldRole::height, {}},  // Spain, Portugal, Latin America
        {"NUMPISOS", FieldRole::levels, {}},
        {"NUM_PISOS", FieldRole::levels, {}},
        {"numberOfFloorsAboveGround", FieldRole::levels, {}},
        {"hgt_median_m", FieldRole::height, m},  // San Francisco
        {"hgt_mediancm", FieldRole::height, LengthUnit::centimetres},
        {"gnd_min_m", FieldRole::groundElevation, m},
        {"BLDG_HGT_2010", FieldRole::height, LengthUnit::feet},  // Boston
        {"GRND_ELEV_2010", FieldRole::groundElevation, LengthUnit::feet},
        {"AVG_HEIGHT", FieldRole::height, {}},  // Toronto
        {"SURF_ELEV", FieldRole::groundElevation, {}},
        {"HGT_AGL", FieldRole::height, {}},  // Vancouver
        {"TOPELEV_M", FieldRole::topElevation, m},
        {"BASEELEV_M", FieldRole::groundElevation, m},
        {"NO_STORIES", FieldRole::levels, {}},           // Chicago
        {"Floor", FieldRole::levels, {}},                // China
        {"bldg:measuredHeight", FieldRole::height, {}},  // Japan
        {"UN_VOL_AV", FieldRole::height, m},             // Italy
        {"liczbaKondygnacji", FieldRole::levels, {}},    // Poland
        {"kerrosluku", FieldRole::levels, {}},           // Finland
    };
    for (const Published& field : fields) {
        const auto meaning = findMeaning(field.name);
        ASSERT_TRUE(meaning) << field.name;
        EXPECT_EQ(meaning->role, field.role) << field.name;
        EXPECT_EQ(meaning->unit, field.unit) << field.name;
    }
}

TEST(FieldRoles, FalseFriendsAreNotTaken) {
    // A clearance; elevations of the gutter; the height of one storey or of all; storeys below the ground.
    for (const char* name : {"maxheight", "Z_MIN", "Z_MAX", "story_ht_", "numberOfFloorsBelowGround",
                             "heightBelowGround", "hgt_mincm", "b3_h_dak_min", "storeysBelowGround"})
        EXPECT_EQ(roleOf(name), std::nullopt) << name;
    // Truncated, names for above and below the ground are equal, and so are metres and centimetres.
    EXPECT_EQ(roleOf("numberOfFl", true), std::nullopt);
    EXPECT_EQ(roleOf("hgt_median", true), std::nullopt);
    EXPECT_EQ(roleOf("BLDG_HGT_2", true), FieldRole::height);
    EXPECT_EQ(findMeaning("BLDG_HGT_2", true)->unit, LengthUnit::feet);
}

TEST(FieldRoles, OfTagsOnlyTheirOwnAreHeights) {
    EXPECT_TRUE(findTagMeaning("building:levels"));
    EXPECT_TRUE(findTagMeaning("min_height"));
    for (const char* key : {"maxheight", "floor", "hoogte", "altura"})
        EXPECT_FALSE(findTagMeaning(key)) << key;
}

std::vector<std::string> namesOf(const std::vector<KnownField>& fields, FieldRole role) {
    std::vector<std::string> names;
    for (const KnownField& field : fields)
        if (field.meaning.role == role) names.push_back(field.name);
    return names;
}

TEST(FieldRoles, ATypicalHeightComesBeforeTheHighestPoint) {
    using enum FieldRole;
    EXPECT_THAT(namesOf(knownFields({"RelHMax", "RelH2"}, {}, false), height),
                ElementsAre("RelH2", "RelHMax"));
    EXPECT_THAT(
        namesOf(knownFields({"b3_h_dak_max", "b3_h_dak_50p", "b3_h_maaiveld"}, {}, false), topElevation),
        ElementsAre("b3_h_dak_50p", "b3_h_dak_max"));
}

TEST(FieldRoles, NeighboursSettleWhatANameMeans) {
    using enum FieldRole;
    // Toronto: the lowest point of the roof, not the underside.
    const auto toronto = knownFields({"MIN_HEIGHT", "MAX_HEIGHT", "AVG_HEIGHT"}, {}, false);
    EXPECT_FALSE(hasRole(toronto, minHeight));
    EXPECT_THAT(namesOf(toronto, height), ElementsAre("AVG_HEIGHT", "MAX_HEIGHT"));
    EXPECT_TRUE(hasRole(knownFields({"height", "min_height"}, {}, false), minHeight));
    // Hong Kong: both are elevations.
    const auto hongKong = knownFields({"BASEHEIGHT", "TOPHEIGHT"}, {}, false);
    EXPECT_THAT(namesOf(hongKong, groundElevation), ElementsAre("BASEHEIGHT"));
    EXPECT_FALSE(hasRole(hongKong, minHeight));
    const auto newer = knownFields({"BASELEVEL", "ROOFLEVEL"}, {}, false);
    EXPECT_THAT(namesOf(newer, groundElevation), ElementsAre("BASELEVEL"));
    EXPECT_THAT(namesOf(newer, topElevation), ElementsAre("ROOFLEVEL"));
    EXPECT_TRUE(hasRole(knownFields({"height", "base_height"}, {}, false), minHeight));
    // An elevation of the roof alone is no height, and makes an elevation of the ground's height.
    EXPECT_FALSE(hasRole(knownFields({"AbsHMax"}, {}, false), height));
    const auto pair = knownFields({"absolute_height", "ground_height"}, {}, false);
    EXPECT_THAT(namesOf(pair, groundElevation), ElementsAre("ground_height"));
    EXPECT_FALSE(hasRole(knownFields({"height", "ground_height"}, {}, false), groundElevation));
}

// Vienna and others name the terrain model that they took the ground's elevation from.
TEST(FieldRoles, ALevelOfTheTerrainIsTheGround) {
    using enum FieldRole;
    for (const char* name : {"HOEHE_DGM", "DGM_Hoehe_m", "MNT", "height DTM", "dtm_elevation"})
        EXPECT_EQ(roleOf(name), groundElevation) << name;
    EXPECT_EQ(roleOf("height_over_dtm"), height);
    EXPECT_EQ(roleOf("Hoehe_ueber_DGM"), height);
    const auto beside = knownFields({"HOEHE_DGM", "HOEHE"}, {}, false);
    EXPECT_THAT(namesOf(beside, height), ElementsAre("HOEHE"));
    EXPECT_THAT(namesOf(beside, groundElevation), ElementsAre("HOEHE_DGM"));
    // Its undersides are those of passages where the ground is stated, else the ground.
    const auto vienna = knownFields({"O_KOTE", "U_KOTE", "HOEHE_DGM"}, {}, false);
    EXPECT_THAT(namesOf(vienna, groundElevation), ElementsAre("HOEHE_DGM"));
    EXPECT_THAT(namesOf(vienna, bottomElevation), ElementsAre("U_KOTE"));
    EXPECT_THAT(namesOf(knownFields({"O_KOTE", "U_KOTE"}, {}, false), groundElevation),
                ElementsAre("U_KOTE"));
}

TEST(FieldRoles, AChosenElevationIsTakenOverTheGround) {
    using enum FieldRole;
    const auto fields = knownFields({"RelH2", "AbsHMax", "AbsH2", "AbsHMin"}, {.height = "abshmax"}, false);
    EXPECT_THAT(namesOf(fields, topElevation), ElementsAre("AbsHMax"));
    EXPECT_FALSE(hasRole(fields, height));
    EXPECT_THAT(namesOf(knownFields({"NIV", "num_floors"}, {.levels = "niv"}, false), levels),
                ElementsAre("NIV"));
}

class Units : public testing::Test {
protected:
    LengthUnit unitOf(const std::vector<std::string>& names, const UnitRules& rules) {
        warnings.clear();
        auto fields = knownFields(names, {}, false);
        settleUnits(fields, rules);
        for (const KnownField& field : fields)
            if (!field.assumption.empty()) warnings.push_back(field.assumption);
        return fields.at(0).unit;
    }
    std::vector<std::string> warnings;
};

TEST_F(Units, AreMetresUnlessStatedOtherwise) {
    EXPECT_EQ(unitOf({"height", "ground_elevation"}, {}), LengthUnit::metres);
    EXPECT_TRUE(warnings.empty());
    EXPECT_EQ(unitOf({"height_ft"}, {}), LengthUnit::feet);
    EXPECT_EQ(unitOf({"height_ft"}, {.stated = LengthUnit::metres}), LengthUnit::metres);
    EXPECT_TRUE(warnings.empty());
}

TEST_F(Units, OfNewYorksFieldsAreFeetAndReported) {
    EXPECT_EQ(unitOf({"HEIGHTROOF", "GROUNDELEV"}, {}), LengthUnit::feet);
    EXPECT_EQ(warnings.size(), 2U);
    EXPECT_EQ(unitOf({"height_roof", "ground_elevation"}, {}), LengthUnit::feet);
    EXPECT_EQ(warnings.size(), 2U);
    EXPECT_EQ(unitOf({"heightroof"}, {}), LengthUnit::metres);
    EXPECT_EQ(warnings.size(), 1U);
    EXPECT_EQ(unitOf({"heightroof", "groundelev"}, {.stated = LengthUnit::metres}), LengthUnit::metres);
    EXPECT_TRUE(warnings.empty());
}

TEST_F(Units, OfAMapInFeetAreNotSilentlyMetres) {
    EXPECT_EQ(unitOf({"height"}, {.mapInFeet = true}), LengthUnit::metres);
    EXPECT_EQ(warnings.size(), 1U);
    EXPECT_EQ(unitOf({"heightroof"}, {.mapInFeet = true}), LengthUnit::feet);
    EXPECT_EQ(warnings.size(), 1U);
}

TEST_F(Units, OfPortlandsFieldsAreFeetOnAMapInFeet) {
    EXPECT_EQ(unitOf({"AVG_HEIGHT"}, {.mapInFeet = true}), LengthUnit::feet);
    EXPECT_EQ(warnings.size(), 1U);
    EXPECT_EQ(unitOf({"AVG_HEIGHT"}, {}), LengthUnit::metres);
    EXPECT_EQ(warnings.size(), 1U);
}

TEST(OtherTags, AreReadAsFarAsTheyGo) {
    EXPECT_THAT(parseTags(R"("height"=>"12","name"=>"a \"b\", c")"),
                ElementsAre(Pair("height", "12"), Pair("name", "a \"b\", c")));
    EXPECT_THAT(parseTags(R"("height"=>"12",broken)"), ElementsAre(Pair("height", "12")));
    EXPECT_TRUE(parseTags("").empty());
    EXPECT_TRUE(parseTags("\"").empty());
    EXPECT_TRUE(parseTags(R"("a"=>"\)").empty());
}

}  // namespace
}  // namespace noonmark
