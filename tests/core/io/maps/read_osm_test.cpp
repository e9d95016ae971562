#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/io/osm/read_osm_buildings.h"
#include "tests/core/io/footprint_files.h"

namespace noonmark {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// OpenStreetMap XML written by hand: a unit is 0.0001 degrees, about 10 m.
class OsmXml {
public:
    OsmXml& node(int id, double x, double y) {
        text_ +=
            fmt::format("<node id=\"{}\" lat=\"{:.7f}\" lon=\"{:.7f}\"/>\n", id, 40 + y * 1e-4, x * 1e-4);
        return *this;
    }
    // A square of side 2 whose nodes are numbered from `first`.
    OsmXml& square(int first, double west, double south) {
        node(first, west, south).node(first + 1, west + 2, south);
        return node(first + 2, west + 2, south + 2).node(first + 3, west, south + 2);
    }
    OsmXml& way(int id, const std::vector<int>& nodes, const tests::Tags& tags = {}) {
        text_ += fmt::format("<way id=\"{}\">", id);
        for (const int node : nodes) text_ += fmt::format("<nd ref=\"{}\"/>", node);
        return end("way", tags);
    }
    OsmXml& relation(int id, const std::vector<std::pair<int, const char*>>& members,
                     const tests::Tags& tags = {}) {
        text_ += fmt::format("<relation id=\"{}\">", id);
        for (const auto& [way, role] : members)
            text_ += fmt::format("<member type=\"way\" ref=\"{}\" role=\"{}\"/>", way, role);
        text_ += "<tag k=\"type\" v=\"multipolygon\"/>";
        return end("relation", tags);
    }
    [[nodiscard]] std::string xml() const { return "<osm version=\"0.6\">\n" + text_ + "</osm>\n"; }

private:
    OsmXml& end(const char* element, const tests::Tags& tags) {
        for (const auto& [key, value] : tags) text_ += fmt::format("<tag k=\"{}\" v=\"{}\"/>", key, value);
        text_ += fmt::format("</{}>\n", element);
        return *this;
    }
    std::string text_;
};

const tests::Tags house{{"building", "yes"}, {"height", "12"}};

class ReadOsm : public testing::Test {
protected:
    Result<OsmBuildings> tryRead(const std::string& text, std::stop_token stop = {}) {
        NoProgress quiet;
        return readOsmBuildings(folder_.file("a.osm", text), OsmFormat::xml, settings, quiet, stop);
    }
    std::vector<UnplacedFeature> read(const OsmXml& osm) {
        auto buildings = tryRead(osm.xml());
        EXPECT_TRUE(buildings) << buildings.error().text();
        return buildings ? std::move(buildings->features) : std::vector<UnplacedFeature>();
    }
    std::vector<std::string> idsOf(const OsmXml& osm) {
        std::vector<std::string> ids;
        for (const UnplacedFeature& feature : read(osm)) ids.push_back(feature.facts.id);
        return ids;
    }

    tests::TemporaryFolder folder_;
    ReadSettings settings;
};

TEST_F(ReadOsm, TakesRelationsFirstAndThenWaysById) {
    OsmXml osm;
    osm.square(1, 0, 0).square(5, 10, 0).square(9, 20, 0);
    osm.way(30, {1, 2, 3, 4, 1}, house).way(20, {5, 6, 7, 8, 5}, house).way(25, {9, 10, 11, 12, 9});
    osm.relation(7, {{25, "outer"}}, house);
    EXPECT_THAT(idsOf(osm), ElementsAre("relation 7", "way 20", "way 30"));
}

TEST_F(ReadOsm, NodesAndWaysMayComeInAnyOrder) {
    OsmXml osm;
    osm.relation(7, {{25, "outer"}}, house).way(25, {4, 3, 2, 1, 4});
    osm.node(4, 0, 2).node(2, 2, 0).node(3, 2, 2).node(1, 0, 0).node(-6, 5, 5);
    const auto found = read(osm);
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found[0].polygons[0][0].size(), 5U);
}

TEST_F(ReadOsm, ARelationWithoutTagsIsDescribedByItsOuterWayAndReplacesIt) {
    OsmXml osm;
    osm.square(1, 0, 0).way(10, {1, 2, 3, 4, 1}, house).relation(7, {{10, "outer"}});
    const auto found = read(osm);
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found[0].facts.id, "relation 7");
    EXPECT_EQ(found[0].facts.heights.topM, 12);
}

TEST_F(ReadOsm, OpenWaysOfARelationAreJoinedAndInnerRingsAreHoles) {
    OsmXml osm;
    osm.node(1, 0, 0).node(2, 9, 0).node(3, 9, 9).node(4, 0, 9).square(5, 3, 3);
    osm.way(10, {1, 2, 3}).way(11, {1, 4, 3}).way(12, {5, 6, 7, 8, 5});
    osm.relation(7, {{10, "outer"}, {11, "outer"}, {12, "inner"}}, house);
    const auto found = read(osm);
    ASSERT_EQ(found.size(), 1U);
    ASSERT_EQ(found[0].polygons.size(), 1U);
    EXPECT_EQ(found[0].polygons[0].size(), 2U) << "an outer ring and a hole";
}

TEST_F(ReadOsm, ARelationWithAMissingWayIsLeftOut) {
    OsmXml osm;
    osm.square(1, 0, 0).way(10, {1, 2, 3, 4, 1}, house).relation(7, {{10, "outer"}, {99, "outer"}}, house);
    EXPECT_THAT(idsOf(osm), ElementsAre("way 10"));
}

TEST_F(ReadOsm, AWayKeepsThoseOfItsNodesThatTheFileHas) {
    OsmXml osm;
    osm.node(1, 0, 0)
        .node(2, 2, 0)
        .node(3, 2, 2)
        .way(10, {1, 2, 3, 99, 1}, house)
        .way(11, {98, 97, 98}, house);
    const auto found = read(osm);
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found[0].polygons[0][0].size(), 4U) << "three nodes, and the first again";
}

TEST_F(ReadOsm, OnlyClosedWaysAreAreasAndTheTagAreaDecidesFirst) {
    OsmXml osm;
    osm.square(1, 0, 0);
    osm.way(10, {1, 2, 3, 4}, house).way(11, {1, 2, 3, 1}, {{"building", "yes"}, {"area", "no"}});
    osm.way(12, {1, 2, 3, 1}, {{"highway", "pedestrian"}, {"area", "yes"}}).way(13, {1, 2, 3, 1}, house);
    const auto buildings = tryRead(osm.xml());
    ASSERT_TRUE(buildings);
    EXPECT_EQ(buildings->features.size(), 1U);
    EXPECT_EQ(buildings->areas, 2U) << "ways 12 and 13";
}

TEST_F(ReadOsm, ATagThatTheUserNamesIsRead) {
    settings.heightField = "eaves";
    OsmXml osm;
    osm.square(1, 0, 0).way(10, {1, 2, 3, 4, 1}, {{"building", "yes"}, {"eaves", "7.5"}});
    const auto found = read(osm);
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found[0].facts.heights.topM, 7.5);
}

TEST_F(ReadOsm, VersionsOfOneThingAreRefused) {
    OsmXml osm;
    osm.square(1, 0, 0).way(10, {1, 2, 3, 4, 1}, house).way(10, {1, 2, 3, 4, 1}, house);
    const auto twice = tryRead(osm.xml());
    ASSERT_FALSE(twice);
    EXPECT_THAT(twice.error().text(), HasSubstr("way 10 twice"));
    const auto node = tryRead(OsmXml().square(1, 0, 0).node(2, 5, 5).way(10, {1, 2, 3, 4, 1}, house).xml());
    ASSERT_FALSE(node);
    EXPECT_THAT(node.error().text(), HasSubstr("node 2 twice"));
}

TEST_F(ReadOsm, TagsAmongNodesAreRefused) {
    const auto mixed = tryRead(
        "<osm version=\"0.6\"><way id=\"4\"><nd ref=\"1\"/><tag k=\"building\" v=\"yes\"/>"
        "<nd ref=\"2\"/></way></osm>");
    ASSERT_FALSE(mixed);
    EXPECT_THAT(mixed.error().text(), HasSubstr("way 4 are mixed"));
}

TEST_F(ReadOsm, EntitiesAndPlacesOffTheEarthAreRefused) {
    const auto bomb = tryRead("<!DOCTYPE osm [<!ENTITY a \"aaaa\">]><osm version=\"0.6\">&a;</osm>");
    ASSERT_FALSE(bomb);
    EXPECT_THAT(bomb.error().text(), HasSubstr("damaged"));
    EXPECT_FALSE(
        tryRead(OsmXml().node(1, 0, 900000).node(2, 1, 0).node(3, 1, 1).way(9, {1, 2, 3, 1}, house).xml()));
}

TEST_F(ReadOsm, AStopRequestEndsIt) {
    std::stop_source source;
    source.request_stop();
    const auto stopped =
        tryRead(OsmXml().square(1, 0, 0).way(10, {1, 2, 3, 4, 1}, house).xml(), source.get_token());
    ASSERT_FALSE(stopped);
    EXPECT_TRUE(isCancelled(stopped.error()));
}

TEST_F(ReadOsm, TheContentTellsTheFormat) {
    EXPECT_EQ(findOsmFormat(folder_.file("a.txt", "<?xml version=\"1.0\"?><osm version=\"0.6\"/>")),
              OsmFormat::xml);
    EXPECT_EQ(findOsmFormat(folder_.file("b", std::string("\0\0\0\x0d\x0a\x09OSMHeader\x18\x7c", 17))),
              OsmFormat::pbf);
    EXPECT_EQ(findOsmFormat(folder_.file("c.osm", "{}")), std::nullopt);
    EXPECT_EQ(findOsmFormat(folder_.file("d.osm", "")), std::nullopt);
}

}  // namespace
}  // namespace noonmark
