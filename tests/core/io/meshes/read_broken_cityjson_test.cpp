#include <gtest/gtest.h>

#include "core/io/pieces/read_part.h"
#include "tests/core/io/cityjson_fixtures.h"
#include "tests/core/io/piece_checks.h"
#include "tests/core/io/temporary_folder.h"

namespace noonmark {
namespace {

using tests::CityJsonMaker;
using tests::Json;
using tests::read;
using tests::readText;
using tests::warns;

TEST(ReadCityJson, OneBadObjectIsAWarning) {
    CityJsonMaker maker;
    maker.addBuilding("good", maker.boxSolid({0, 0, 0}, {10, 10, 10}));
    Json bad = maker.boxSolid({20, 0, 0}, {30, 10, 10});
    const Json broken[] = {999, -1, 1.5, "x", nullptr, Json::array(), 4294967296};
    for (std::size_t i = 0; i < std::size(broken); ++i) {
        bad["boundaries"][0][1][0][0] = broken[i];
        maker.addBuilding("bad" + std::to_string(i), bad);
    }
    for (const Json& boundaries : {Json(), Json("x"), Json(5), Json::array({5}),
                                   Json::array({Json::array({Json::array({Json::array()})})})})
        maker.addBuilding("worse" + std::to_string(maker.objects.size()), CityJsonMaker::solid(boundaries));
    Json document = maker.document();
    document["vertices"].push_back({"a", nullptr, 1});
    const auto piece = read(document);
    ASSERT_TRUE(piece) << piece.error().text();
    EXPECT_EQ(piece->buildings.size(), 8U);  // the broken ones lost one face
    EXPECT_TRUE(warns(*piece, "surfaces with missing vertices"));
    EXPECT_TRUE(warns(*piece, "not closed"));
}

TEST(ReadCityJson, ParentsThatGoRoundEnd) {
    CityJsonMaker maker;
    maker.addBuilding("a", maker.boxSolid({0, 0, 0}, {10, 10, 10}), "BuildingPart");
    maker.addBuilding("b", maker.boxSolid({20, 0, 0}, {30, 10, 10}), "BuildingPart");
    maker.objects["a"]["parents"] = {"b"};
    maker.objects["b"]["parents"] = {"a"};
    const auto piece = read(maker.document());
    ASSERT_TRUE(piece);
    std::size_t parts = 0;
    for (const auto& building : piece->buildings) parts += building->parts.size();
    EXPECT_EQ(parts, 2U);
}

TEST(ReadCityJson, FilesWithoutAPlaceAreErrors) {
    CityJsonMaker maker;
    maker.addBuilding("cube", maker.boxSolid({0, 0, 0}, {10, 10, 10}));
    const auto none = read(maker.document("2.0", ""));
    ASSERT_FALSE(none);
    EXPECT_NE(none.error().what.find("no coordinate reference system"), std::string::npos);
    ReadSettings stated;
    stated.crs = "EPSG:7415";
    EXPECT_TRUE(read(maker.document("2.0", ""), stated));
    EXPECT_FALSE(read(maker.document("2.0", "EPSG:999999")));
    const auto elsewhere = read(maker.document("2.0", "EPSG:2193"));  // New Zealand
    ASSERT_FALSE(elsewhere);
    EXPECT_NE(elsewhere.error().what.find("cannot belong to"), std::string::npos);
    EXPECT_FALSE(read(maker.document("2.0", "EPSG:4326")));
}

TEST(ReadCityJson, FilesWithNothingAreErrors) {
    for (const char* text : {"", "{}", "[]", "5", "{\"type\":\"CityJSON\"}", "{\"type\":\"CityJSONFeature\"}",
                             "\xff\xfe", "{\"type\":\"CityJSON\",\"vertices\":[[1e999,0,0]]}"}) {
        const auto piece = readText(text);
        ASSERT_FALSE(piece) << text;
        EXPECT_FALSE(piece.error().text().empty());
    }
    EXPECT_FALSE(read(CityJsonMaker().document()));
    NoProgress progress;
    EXPECT_FALSE(readCityJson("/nowhere/city.json", {}, progress, {}));
}

TEST(ReadCityJson, TruncatedAnywhereNeverCrashes) {
    CityJsonMaker maker;
    maker.addBuilding("cube", maker.boxSolid({0, 0, 0}, {10, 10, 10}));
    const std::string whole = maker.document().dump();
    for (std::size_t length = 0; length < whole.size(); length += 11)
        EXPECT_FALSE(readText(whole.substr(0, length))) << length;
}

TEST(ReadCityJson, Stops) {
    CityJsonMaker maker;
    maker.addBuilding("cube", maker.boxSolid({0, 0, 0}, {10, 10, 10}));
    const tests::TemporaryFolder folder;
    NoProgress progress;
    std::stop_source source;
    source.request_stop();
    const auto piece =
        readCityJson(folder.file("city.json", maker.document().dump()), {}, progress, source.get_token());
    ASSERT_FALSE(piece);
    EXPECT_TRUE(isCancelled(piece.error()));
}

}  // namespace
}  // namespace noonmark
