#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/io/osm/read_osm_buildings.h"
#include "tests/core/io/city_reading.h"
#include "tests/core/io/temporary_folder.h"

namespace noonmark {
namespace {

using testing::HasSubstr;

// The tags and the places of a house of 0.0004 by 0.0002 degrees near Berlin: 27.1 by 22.3 m.
constexpr const char* overpassTags = R"("tags":{"building":"yes","height":"20","name":"A & \"B\" <C>"})";
constexpr const char* overpassShape =
    R"([{"lat":52.5,"lon":13.4},{"lat":52.5,"lon":13.4004},{"lat":52.5002,"lon":13.4004},)"
    R"({"lat":52.5002,"lon":13.4},{"lat":52.5,"lon":13.4}])";
constexpr double overpassHouseM2 = 27.15 * 22.25;

std::string nodeJson(int id, double lon, double lat, const std::string& more = "") {
    return fmt::format(R"({{"type":"node","id":{},"lat":{:.4f},"lon":{:.4f}{}}})", id, lat, lon, more);
}

const std::string overpassNodes = nodeJson(1, 13.4, 52.5) + "," + nodeJson(2, 13.4004, 52.5) + "," +
                                  nodeJson(3, 13.4004, 52.5002) + "," + nodeJson(4, 13.4, 52.5002);

class Overpass : public tests::CityReading {
protected:
    std::filesystem::path answer(const std::string& elements, const std::string& more = "") {
        return folder.file("export.json",
                           R"({"version":0.6,"generator":"Overpass API 0.7.62",)"
                           R"("osm3s":{"copyright":"from www.openstreetmap.org"},"elements":[)" +
                               elements + "]" + more + "}");
    }
    std::string errorOf(const std::filesystem::path& file) {
        NoProgress quiet;
        const auto result = readCity({file}, settings, quiet, {});
        EXPECT_FALSE(result);
        return result ? "" : result.error().text();
    }
    void expectHouse(const CityRead& read) {
        EXPECT_EQ(read.format, "OpenStreetMap JSON (Overpass)");
        ASSERT_EQ(read.city.buildings.size(), 1U);
        const Building& house = *read.city.buildings[0];
        EXPECT_EQ(house.sourceId, "way 10");
        EXPECT_EQ(house.name, "A & \"B\" <C>");
        EXPECT_EQ(house.parts.at(0).topM, 20);
        EXPECT_NEAR(area(house.parts[0].footprint), overpassHouseM2, 1);
    }

    tests::TemporaryFolder folder;
};

TEST_F(Overpass, WaysWithShapesAreRead) {
    const std::string named = fmt::format(R"({{"type":"way","id":10,"nodes":[1,2,3,4,1],"geometry":{},{}}})",
                                          overpassShape, overpassTags);
    expectHouse(read({answer(named)}));
    expectHouse(read({answer(named + "," + named)}));  // an element that comes twice counts once
    expectHouse(read(
        {answer(fmt::format(R"({{"type":"way","id":10,"geometry":{},{}}})", overpassShape, overpassTags))}));
}

TEST_F(Overpass, WaysWithNodesAreRead) {
    const std::string way = fmt::format(R"({{"type":"way","id":10,"nodes":[1,2,3,4,1],{}}})", overpassTags);
    expectHouse(read({answer(overpassNodes + "," + way)}));
    expectHouse(read({answer(way + "," + overpassNodes)}));
}

// A court of a quarter of the building. The members have shapes and no ids of nodes.
TEST_F(Overpass, RelationsBringTheirWaysAlong) {
    const std::string court =
        R"([{"lat":52.50005,"lon":13.4001},{"lat":52.50005,"lon":13.4003},{"lat":52.50015,"lon":13.4003},)"
        R"({"lat":52.50015,"lon":13.4001},{"lat":52.50005,"lon":13.4001}])";
    const std::string relation = fmt::format(
        R"({{"type":"relation","id":5,"members":[{{"type":"way","ref":10,"role":"outer","geometry":{}}},)"
        R"({{"type":"way","ref":11,"role":"inner","geometry":{}}}],)"
        R"("tags":{{"type":"multipolygon","building":"yes","height":"12"}}}})",
        overpassShape, court);
    const CityRead made = read({answer(relation)});
    ASSERT_EQ(made.city.buildings.size(), 1U);
    EXPECT_EQ(made.city.buildings[0]->sourceId, "relation 5");
    EXPECT_NEAR(area(made.city.buildings[0]->parts.at(0).footprint), overpassHouseM2 * 3 / 4, 1);
}

TEST_F(Overpass, TreesAreReadBesideBuildings) {
    const std::string way = fmt::format(R"({{"type":"way","id":10,"nodes":[1,2,3,4,1],{}}})", overpassTags);
    const CityRead made =
        read({answer(overpassNodes + "," + way + "," +
                     nodeJson(7, 13.401, 52.5, R"(,"tags":{"natural":"tree","height":"9"})"))});
    ASSERT_TRUE(made.city.trees);
    EXPECT_EQ(made.city.trees->trees.size(), 1U);
}

TEST_F(Overpass, WhatIsNoCityIsRefusedWithAdvice) {
    const std::string bare = fmt::format(R"({{"type":"way","id":10,"nodes":[1,2,3,4,1],{}}})", overpassTags);
    EXPECT_THAT(errorOf(answer(bare)), HasSubstr("out geom;"));
    EXPECT_THAT(errorOf(answer(overpassNodes, R"(,"remark":"runtime error: Query timed out")")),
                HasSubstr("broke its answer off: runtime error: Query timed out"));
    EXPECT_THAT(errorOf(answer("")), HasSubstr("It holds no polygons"));
    EXPECT_THAT(
        errorOf(folder.file("cut.json", R"({"generator":"Overpass API","elements":[{"type":"node",)")),
        HasSubstr("incomplete or damaged"));
}

// A box of the query cuts shapes off: null stands for the points outside.
TEST_F(Overpass, ElementsOfAnotherKindAreLeftOut) {
    const std::string odd =
        R"({"type":"way","id":"x"},{"type":"way"},{"type":5,"id":1},7,null,[],{"type":"node","id":3},)"
        R"({"type":"way","id":20,"nodes":["a",1.5,null],"tags":{"building":"yes"}},)"
        R"({"type":"way","id":21,"geometry":[null,{"lat":"52"},{"lat":95,"lon":1}],"tags":{"building":7}},)"
        R"({"type":"relation","id":6,"members":[3,{"ref":1},{"type":"way"}],"tags":[]},)";
    expectHouse(read({answer(
        odd + fmt::format(R"({{"type":"way","id":10,"geometry":{},{}}})", overpassShape, overpassTags))}));
}

TEST_F(Overpass, TheContentTellsTheFormat) {
    EXPECT_EQ(findOsmFormat(answer("")), OsmFormat::overpass);
    EXPECT_EQ(
        findOsmFormat(folder.file("b.json", R"({"version":"0.6","generator":"CGImap 0.9","elements":[]})")),
        OsmFormat::overpass);
    EXPECT_EQ(findOsmFormat(folder.file("c.json", R"({"elements":[]})")), std::nullopt);
}

}  // namespace
}  // namespace noonmark
