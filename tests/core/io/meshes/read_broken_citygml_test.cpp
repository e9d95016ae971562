#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/core/io/citygml_fixtures.h"
#include "tests/core/io/piece_checks.h"

namespace noonmark {
namespace {

using testing::HasSubstr;
using tests::bonn;
using tests::cityGml;
using tests::expectClosedSolid;
using tests::gmlBoxFaces;
using tests::gmlBoxSolid;
using tests::gmlBuilding;
using tests::gmlSolid;
using tests::readGmlText;
using tests::TemporaryFolder;
using tests::warns;

std::string smallCityGml() { return cityGml(gmlBuilding("cube", gmlBoxSolid({0, 0, 0}, {10, 20, 30}))); }

void expectBroken(const std::string& text, const char* why) {
    const auto piece = readGmlText(text);
    ASSERT_FALSE(piece) << why;
    EXPECT_THAT(piece.error().text(), HasSubstr(why));
}

TEST(ReadBrokenCityGml, AFileCutOffAnywhereIsRefused) {
    const std::string text = smallCityGml();
    for (std::size_t length = 0; length < text.size() - 2; length += 37) {
        const auto piece = readGmlText(text.substr(0, length));
        ASSERT_FALSE(piece) << length;
        EXPECT_THAT(piece.error().text(), HasSubstr("not valid XML"));
    }
}

TEST(ReadBrokenCityGml, AnErrorNamesItsLine) {
    const auto piece = readGmlText(smallCityGml().replace(smallCityGml().find("</bldg:Building>"), 3, "x"));
    ASSERT_FALSE(piece);
    EXPECT_THAT(piece.error().where, HasSubstr("city.gml: line 4"));
}

TEST(ReadBrokenCityGml, EntitiesAreRefusedBeforeTheyGrow) {
    std::string bomb = "<!DOCTYPE x [<!ENTITY a0 \"ha\">";
    for (int i = 1; i < 30; ++i) bomb += fmt::format("<!ENTITY a{} \"&a{};&a{};\">", i, i - 1, i - 1);
    expectBroken(bomb + "]><CityModel>&a29;</CityModel>", "declares an entity");
    expectBroken("<!DOCTYPE x [<!ENTITY f SYSTEM \"file:///etc/hostname\">]><CityModel>&f;</CityModel>",
                 "declares an entity");
}

TEST(ReadBrokenCityGml, ADeepFileIsRefused) {
    std::string deep = "<CityModel>";
    for (int i = 0; i < 100'000; ++i) deep += "<a>";
    expectBroken(deep, "nested more than 200 deep");
}

TEST(ReadBrokenCityGml, AnEndlessTagIsRefused) {
    expectBroken("<CityModel a=\"" + std::string(20'000'000, 'a'), "more than 16 MiB");
}

TEST(ReadBrokenCityGml, AnotherKindOfXmlIsRefused) {
    expectBroken("<kml><Document/></kml>", "This is not CityGML: it begins with <kml>");
    expectBroken(cityGml(""), "holds no buildings and no terrain");
}

TEST(ReadBrokenCityGml, BrokenOutlinesAreDroppedAndCounted) {
    auto faces = gmlBoxFaces(bonn, bonn + glm::dvec3(10, 10, 7));
    for (const char* numbers :
         {"1 2 3 4", "1 2 3 a b c", "nan nan nan 1 1 1 2 2 2", "1e999 1 1 2 2 2 3 3 3", ""})
        faces.push_back(
            fmt::format("<gml:Polygon><gml:exterior><gml:LinearRing><gml:posList>{}</gml:posList>"
                        "</gml:LinearRing></gml:exterior></gml:Polygon>",
                        numbers));
    const auto piece = readGmlText(
        cityGml(gmlBuilding("house", "<bldg:lod2Solid>" + gmlSolid(faces) + "</bldg:lod2Solid>")));
    ASSERT_TRUE(piece) << piece.error().text();
    expectClosedSolid(piece->buildings.at(0)->parts.at(0), 700);
    EXPECT_TRUE(warns(*piece, "fewer than three corners or without numbers"));
    EXPECT_THAT(piece->warnings.at(0).where, HasSubstr("house (5)"));
}

TEST(ReadBrokenCityGml, ABuildingWithoutGeometryIsDropped) {
    const auto piece = readGmlText(cityGml(gmlBuilding("cube", gmlBoxSolid({0, 0, 0}, {10, 20, 30})) +
                                           gmlBuilding("ghost", "<bldg:roofType>1</bldg:roofType>")));
    ASSERT_TRUE(piece) << piece.error().text();
    EXPECT_EQ(piece->buildings.size(), 1U);
    EXPECT_TRUE(warns(*piece, "has no usable geometry"));
}

TEST(ReadBrokenCityGml, AStopEndsTheReading) {
    const TemporaryFolder folder;
    NoProgress quiet;
    std::stop_source source;
    source.request_stop();
    const auto piece = readCityGml(folder.file("city.gml", smallCityGml()), {}, quiet, source.get_token());
    ASSERT_FALSE(piece);
    EXPECT_TRUE(isCancelled(piece.error()));
}

}  // namespace
}  // namespace noonmark
