#include "core/io/heights/name_words.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/io/files/readable_text.h"
#include "core/io/heights/field_roles.h"
#include "core/io/heights/unknown_fields.h"

namespace noonmark {
namespace {

using testing::ElementsAre;

TEST(NameWords, EndAtCapitalsDigitsAndPunctuation) {
    EXPECT_THAT(wordsOfName("HeightInFeet"), ElementsAre("height", "in", "feet"));
    EXPECT_THAT(wordsOfName("BLDGHeight_2010"), ElementsAre("bldg", "height"));
    EXPECT_THAT(wordsOfName("addr:postcode"), ElementsAre("addr", "postcode"));
    EXPECT_THAT(wordsOfName("story_ht_"), ElementsAre("story", "ht"));
}

TEST(NameWords, WrittenTogetherAreToldApartWhereAllAreKnown) {
    EXPECT_THAT(wordsOfName("heightinfeet"), ElementsAre("height", "in", "feet"));
    EXPECT_THAT(wordsOfName("建物高さ"), ElementsAre("建物", "高さ"));
    EXPECT_THAT(wordsOfName("weight"), ElementsAre("weight"));
}

TEST(NameWords, AreFoldedInEveryScript) {
    EXPECT_EQ(foldName("Höhe (m)"), "hohem");
    EXPECT_EQ(foldName("WYSOKOŚĆ"), "wysokosc");
    EXPECT_EQ(foldName("Straße"), "strasse");
    EXPECT_EQ(foldName("ВЫСОТА"), "высота");
    EXPECT_EQ(foldName("ΎΨΟΣ"), foldName("ύψος"));
    EXPECT_EQ(foldName("ＨＥＩＧＨＴ"), "height");
    EXPECT_EQ(foldName("Înălțime"), "inaltime");
    EXPECT_EQ(foldName("chiều cao"), "chieucao");
    EXPECT_EQ(foldName("Ho\xCC\x88he"), "hohe") << "an accent behind its letter";
}

TEST(ReadableText, IsUtf8WhateverTheTableUses) {
    EXPECT_EQ(readableText("Höhe"), "Höhe");
    EXPECT_EQ(readableText("H\xF6he"), "Höhe");
    EXPECT_EQ(readableText("OPERAT\xD6R"), "OPERATÖR");
    EXPECT_EQ(readableText("5 \x80"), "5 €");
    EXPECT_EQ(readableText(""), "");
}

TEST(ReadableText, JapaneseTablesAreKnownByTheirPairs) {
    EXPECT_EQ(readableText("\x8D\x82\x82\xB3"), "高さ");
    EXPECT_EQ(readableText("\x96\xBC\x8F\xCC"), "名称");
    EXPECT_EQ(guessEncoding("\x8D\x82\x82\xB3"), TextEncoding::cp932);
    for (const char* latin : {"Stra\xDF"
                              "e",
                              "\x8Aumava", "caf\xE9\xE9\xE0\xE0", "\x93quoted\x94", "\x8D"})
        EXPECT_EQ(guessEncoding(latin), TextEncoding::windows1252) << latin;
}

// Bytes as iconv and Python write them.
TEST(ReadableText, ChineseAndKoreanTablesAreKnownByTheirWords) {
    struct Written {
        const char *bytes, *text;
        TextEncoding encoding;
    };
    for (const auto& [bytes, text, encoding] :
         {Written{"\xBC\xD3\xB0\xAA", "樓高", TextEncoding::big5},
          Written{"\xBC\xD3\xBC\x68\xBC\xC6", "樓層數", TextEncoding::big5},
          Written{"\xA5\x78\xA5\x5F\xA5\xAB", "台北市", TextEncoding::big5},
          Written{"\xC2\xA5\xB8\xDF", "楼高", TextEncoding::gbk},
          Written{"\xC9\xCF\xBA\xA3\xCA\xD0", "上海市", TextEncoding::gbk},
          Written{"\xB3\xF4\xC0\xCC", "높이", TextEncoding::cp949},
          Written{"\xBC\xAD\xBF\xEF\xBD\xC3\xC3\xBB", "서울시청", TextEncoding::cp949}}) {
        EXPECT_EQ(guessEncoding(bytes), encoding) << text;
        EXPECT_EQ(readableText(bytes), text);
    }
    for (const char* latin : {"\xA9M\xF6"
                              "bel",
                              "N\xBA 5", "\xA1\xC9l!", "\xAB\xC9t\xE9\xBB", "3\xB1\xBD", "\xE9\xE8\xC0\xC9"})
        EXPECT_EQ(guessEncoding(latin), TextEncoding::windows1252) << latin;
}

// A short name can be of several encodings; what the table is in decides.
TEST(ReadableText, TheTablesEncodingDecidesWhereItFits) {
    constexpr const char* city = "\xBC\xD3\xB0\xAA";
    EXPECT_EQ(readableText(city, TextEncoding::gbk), "加蔼");
    EXPECT_EQ(readableText("H\xF6he", TextEncoding::windows1252), "Höhe");
    EXPECT_EQ(readableText("H\xF6he \xFF", TextEncoding::big5), "Höhe ÿ") << "it does not fit";
    EXPECT_EQ(readableText("樓高", TextEncoding::big5), "樓高") << "UTF-8 is UTF-8";
}

struct Named {
    const char* name;
    FieldRole role;
    std::optional<LengthUnit> unit;
};

// Names that no list holds, in the languages of the world's open data.
TEST(FieldWords, SayHeightsStoreysAndUnits) {
    constexpr auto m = LengthUnit::metres;
    constexpr auto ft = LengthUnit::feet;
    const Named names[] = {
        {"height_in_feet", FieldRole::height, ft},
        {"HeightInFeet", FieldRole::height, ft},
        {"Höhe_m", FieldRole::height, m},
        {"Gebäudehöhe", FieldRole::height, {}},
        {"înălțime", FieldRole::height, {}},
        {"chiều cao", FieldRole::height, {}},
        {"chieu_cao", FieldRole::height, {}},
        {"số tầng", FieldRole::levels, {}},
        {"αριθμός ορόφων", FieldRole::levels, {}},
        {"HEIGHT_INCHES", FieldRole::height, LengthUnit::inches},
        {"height_dm", FieldRole::height, LengthUnit::decimetres},
        {"building_height_mm", FieldRole::height, LengthUnit::millimetres},
        {"建物高さ", FieldRole::height, {}},
        {"建筑高度", FieldRole::height, {}},
        {"건물높이", FieldRole::height, {}},
        {"hght_cm", FieldRole::height, LengthUnit::centimetres},
        {"maximum_roof_height", FieldRole::height, {}},
        {"höjd", FieldRole::height, {}},
        {"højde_m", FieldRole::height, m},
        {"Výška budovy", FieldRole::height, {}},
        {"wysokość_m", FieldRole::height, m},
        {"высота здания", FieldRole::height, {}},
        {"ύψος κτιρίου", FieldRole::height, {}},
        {"hauteur_moyenne", FieldRole::height, {}},
        {"altura_edificio", FieldRole::height, {}},
        {"altezza media", FieldRole::height, {}},
        {"bina_yukseklik", FieldRole::height, {}},
        {"height_above_ground_ft", FieldRole::height, ft},
        {"absolute_height", FieldRole::topElevation, {}},
        {"roof_elevation_ft", FieldRole::topElevation, ft},
        {"terrain_elevation_m", FieldRole::groundElevation, m},
        {"number_of_stories_above_ground", FieldRole::levels, {}},
        {"этажность", FieldRole::levels, {}},
        {"地上階数", FieldRole::levels, {}},
        {"지상층수", FieldRole::levels, {}},
        {"Počet podlaží", FieldRole::levels, {}},
        {"nombre_etages", FieldRole::levels, {}},
        {"AnzahlVollgeschosse", FieldRole::levels, {}},
    };
    for (const Named& named : names) {
        const auto meaning = findMeaning(named.name);
        ASSERT_TRUE(meaning) << named.name;
        EXPECT_EQ(meaning->role, named.role) << named.name;
        EXPECT_EQ(meaning->unit, named.unit) << named.name;
    }
}

TEST(FieldWords, AWordThatIsNotKnownOrSaysOtherwiseDecidesNothing) {
    for (const char* name :
         {"story_ht_", "floor_area", "height_class", "ground_floor", "地下階数", "min_roof_height",
          "height_limit", "PREC_PLANI", "lod", "addr:postcode", "number", "storeys_ft"})
        EXPECT_FALSE(findMeaning(name)) << name;
}

TEST(FieldWords, NamesInOtherScriptsAreNotEqual) {
    EXPECT_FALSE(isSameField("建物高さ", "階数"));
    EXPECT_TRUE(isSameField("HÖHE", "höhe"));
}

TEST(FieldWords, TheHeightOfTheRoofIsThatOfTheBuildingOutsideTags) {
    const auto role = [](const std::vector<std::string>& names) {
        return knownFields(names, {}, false).front().meaning.role;
    };
    EXPECT_EQ(role({"roofheight"}), FieldRole::height);
    EXPECT_EQ(role({"roof_height_ft"}), FieldRole::height);
    EXPECT_EQ(knownFields({"roof_height_ft"}, {}, false).front().meaning.unit, LengthUnit::feet);
    EXPECT_EQ(role({"roof:height"}), FieldRole::roofHeight);
    EXPECT_TRUE(hasRole(knownFields({"roof_height", "roof_shape"}, {}, false), FieldRole::roofHeight));
    EXPECT_TRUE(hasRole(knownFields({"roof_height", "height"}, {}, false), FieldRole::roofHeight));
}

std::vector<UnknownField> listed(UnknownFields& fields) { return fields.listPossibleHeights("a.shp"); }

TEST(UnknownFields, ANameThatSaysStoreysIsNoHeight) {
    UnknownFields fields;
    for (const double value : {1.0, 1.5, 2.0, 62.0}) fields.add("story_ht_", "", value);
    ASSERT_EQ(listed(fields).size(), 1U);
    EXPECT_EQ(selectingOptions(listed(fields)[0]), "--levels-field story_ht_");
}

TEST(UnknownFields, WithoutAWordFractionsAreHeightsAndWholeNumbersEither) {
    UnknownFields fields;
    for (const double value : {12.5, 13.0, 41.5})
        fields.add("H1", "", value), fields.add("H2", "", 2 * value);
    ASSERT_EQ(listed(fields).size(), 2U);
    EXPECT_EQ(selectingOptions(listed(fields)[0]), "--height-field H1");
    EXPECT_EQ(selectingOptions(listed(fields)[1]), "--levels-field H2 or --height-field H2");
}

TEST(UnknownFields, TheHeightOfOneStoreyIsNotListed) {
    UnknownFields fields;
    for (const double value : {2.8, 3.1, 3.35}) fields.add("storey_height", "", value);
    EXPECT_TRUE(listed(fields).empty());
}

TEST(UnknownFields, CodesAndQualitiesAreNotListed) {
    UnknownFields fields;
    for (const char* code : {"01", "10", "94"}) fields.add("MURS", code, {});
    for (const char* name : {"addr:postcode", "lod", "PREC_PLANI", "yearBuilt", "floor_area", "nb_logements"})
        for (const double value : {1.0, 2.0, 2.5}) fields.add(name, "", value);
    EXPECT_TRUE(listed(fields).empty());
}

TEST(UnknownFields, AHeightIsOneWhateverItsValues) {
    UnknownFields fields;
    for (const double value : {10.0, 33.0, 50.0}) fields.add("ridge_hght_ft", "", value);
    const UnknownField field = listed(fields).at(0);
    EXPECT_EQ(selectingOptions(field), "--height-field ridge_hght_ft --height-unit ft");
}

TEST(UnknownFields, StoreysOfAnotherFieldTellWhatOneHolds) {
    UnknownFields fields;
    for (const double value : {10.0, 33.0, 50.0}) fields.add("H1", "", value), fields.add("H2", "", value);
    fields.compare("H1", {.perStorey = 10.5});
    fields.compare("H2", {.followsFootprint = true});
    ASSERT_EQ(listed(fields).size(), 1U);
    EXPECT_EQ(selectingOptions(listed(fields)[0]), "--height-field H1 --height-unit ft");
}

TEST(UnknownFields, AnElevationSaysWhatItCountsFrom) {
    UnknownFields fields;
    for (const double value : {10.4, 33.1}) fields.add("b3_h_max", "", value);
    EXPECT_EQ(listed(fields).at(0).kind, FieldKind::elevations);
    EXPECT_THAT(describe(listed(fields)[0]), testing::HasSubstr("above the datum"));
}

}  // namespace
}  // namespace noonmark
