#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <algorithm>
#include <fstream>

#include "core/io/context/read_context.h"
#include "tests/core/io/osm_text.h"
#include "tests/core/io/temporary_folder.h"
#include "tests/shared/shared_data.h"

namespace noonmark {

namespace {

const Box2 coastBox{{-1000, -1000}, {1000, 1000}};
constexpr double coastBoxM2 = 2000.0 * 2000;

double seaAreaOf(const Sea& sea) {
    double sum = 0;
    for (const Footprint& polygon : sea.polygons) sum += area(polygon);
    return sum;
}

bool liesInSea(const Sea& sea, glm::dvec2 point) {
    return std::ranges::any_of(sea.polygons,
                               [&](const Footprint& polygon) { return contains(polygon, point); });
}

CoastLine turnedRound(CoastLine line) {
    std::ranges::reverse(line);
    return line;
}

// Counter-clockwise, land inside.
CoastLine islandAt(double x, double y) {
    return {{x, y}, {x + 200, y}, {x + 200, y + 200}, {x, y + 200}, {x, y}};
}

TEST(Coast, TheSeaLiesOnTheRight) {
    const CoastLine eastwards{{-1500, 0}, {1500, 0}};
    const Sea south = findSea({eastwards}, coastBox), north = findSea({turnedRound(eastwards)}, coastBox);
    EXPECT_NEAR(seaAreaOf(south), coastBoxM2 / 2, 1);
    EXPECT_TRUE(liesInSea(south, {0, -500}));
    EXPECT_FALSE(liesInSea(south, {0, 500}));
    EXPECT_TRUE(liesInSea(north, {0, 500}));
    EXPECT_TRUE(south.continuedM.empty());
    EXPECT_TRUE(south.openEnds.empty());
}

TEST(Coast, WaysAreChainedWhateverTheirOrder) {
    const Sea sea = findSea(
        {{{300, 50}, {1500, 0}}, {{-1500, 0}, {-300, 20}}, {{-300, 20}, {0, -80}, {300, 50}}}, coastBox);
    EXPECT_TRUE(sea.openEnds.empty());
    EXPECT_EQ(sea.polygons.size(), 1U);
    EXPECT_TRUE(liesInSea(sea, {0, -100}));
    EXPECT_FALSE(liesInSea(sea, {0, -60}));
}

TEST(Coast, AnIslandIsLandInTheSea) {
    const Sea sea = findSea({islandAt(0, 0)}, coastBox);
    EXPECT_NEAR(seaAreaOf(sea), coastBoxM2 - 200 * 200, 1);
    EXPECT_FALSE(liesInSea(sea, {100, 100}));
    EXPECT_TRUE(liesInSea(sea, {-500, 0}));
    const Sea lagoon = findSea({turnedRound(islandAt(0, 0))}, coastBox);
    EXPECT_NEAR(seaAreaOf(lagoon), 200 * 200, 1) << "the sea inside a ring of land";
}

TEST(Coast, ABayReachesIntoTheLand) {
    const CoastLine bay{{-1500, 0}, {-200, 0}, {-200, 600}, {200, 600}, {200, 0}, {1500, 0}};
    const Sea sea = findSea({bay, islandAt(-100, 100)}, coastBox);
    EXPECT_NEAR(seaAreaOf(sea), coastBoxM2 / 2 + 400 * 600 - 200 * 200, 1);
    EXPECT_TRUE(liesInSea(sea, {150, 500}));
    EXPECT_FALSE(liesInSea(sea, {0, 200})) << "the island in the bay";
    EXPECT_FALSE(liesInSea(sea, {500, 500}));
}

TEST(Coast, ABrokenCoastGivesNoSeaAndIsCounted) {
    const Sea sea = findSea({{{-1500, 0}, {0, 0}}}, coastBox);
    EXPECT_TRUE(sea.polygons.empty());
    ASSERT_EQ(sea.openEnds.size(), 1U);
    EXPECT_EQ(sea.openEnds[0], glm::dvec2(0, 0));
    const Sea withIsland = findSea({{{-1500, 0}, {0, 0}}, islandAt(300, 300)}, coastBox);
    EXPECT_TRUE(withIsland.polygons.empty()) << "what lies around the island is not known";
}

TEST(Coast, WhatLiesApartFromABrokenCoastIsKnown) {
    const Sea sea = findSea({{{-1500, 0}, {1500, 0}}, {{-1500, 500}, {0, 500}}}, coastBox);
    EXPECT_EQ(sea.openEnds.size(), 1U);
    EXPECT_NEAR(seaAreaOf(sea), coastBoxM2 / 2, 1);
}

TEST(Coast, ACoastMayRunAlongTheEdge) {
    const Sea land = findSea({{{-1500, -1000}, {-500, -1000}, {1500, -1000}}}, coastBox);
    EXPECT_TRUE(land.polygons.empty()) << "the sea begins where the box ends";
    const Sea sea = findSea({{{1500, -1000}, {500, -1000}, {-1500, -1000}}}, coastBox);
    EXPECT_NEAR(seaAreaOf(sea), coastBoxM2, 1);
}

TEST(Coast, GoesOnStraightToANearEdgeAndSaysHowFar) {
    const Sea sea = findSea({{{-940, 0}, {850, 0}}}, coastBox);
    EXPECT_NEAR(seaAreaOf(sea), coastBoxM2 / 2, 1);
    EXPECT_THAT(sea.continuedM, testing::UnorderedElementsAre(60, 150));
}

TEST(Coast, CoastsThatMeetHeadOnAreNotTakenForOne) {
    const Sea sea = findSea({{{-1500, 0}, {0, 0}}, {{1500, 0}, {0, 0}}}, coastBox);
    EXPECT_TRUE(sea.polygons.empty());
    EXPECT_EQ(sea.openEnds.size(), 1U);
    EXPECT_EQ(sea.contradictions, 2U) << "one on either side";
}

TEST(Coast, WithoutCoastThereIsNoSea) { EXPECT_TRUE(findSea({}, coastBox).polygons.empty()); }

using testing::HasSubstr;

const Frame contextFrame({-73.98, 40.75});

Result<ContextRead> readContextFrom(const std::filesystem::path& file) {
    NoProgress quiet;
    return readContext(file, {}, contextFrame, quiet, {});
}

TEST(ContextTags, SayWhatIsDrawn) {
    EXPECT_EQ(classifyContextArea({{"natural", "water"}}), ContextKind::water);
    EXPECT_EQ(classifyContextArea({{"leisure", "park"}, {"landuse", "grass"}}), ContextKind::park);
    EXPECT_FALSE(classifyContextArea({{"leisure", "park"}, {"layer", "-1"}}));
    EXPECT_FALSE(classifyContextArea({{"leisure", "park"}, {"building", "yes"}}));
    EXPECT_EQ(classifyContextArea({{"natural", "water"}, {"layer", "-1"}}), ContextKind::water)
        << "a river under bridges";
    EXPECT_FALSE(classifyContextArea({{"natural", "water"}, {"layer", "-1"}, {"tunnel", "culvert"}}));
    EXPECT_FALSE(classifyContextArea({{"leisure", "swimming_pool"}, {"layer", "-1"}})) << "in a cellar";
    EXPECT_EQ(classifyContextLine({{"highway", "residential"}}), ContextKind::street);
    EXPECT_EQ(classifyContextLine({{"highway", "footway"}}), ContextKind::path);
    EXPECT_EQ(classifyContextLine({{"railway", "rail"}}), ContextKind::rail);
    EXPECT_FALSE(classifyContextLine({{"railway", "subway"}, {"tunnel", "yes"}}));
    EXPECT_FALSE(classifyContextLine({{"highway", "proposed"}}));
    EXPECT_EQ(classifyContextPoint({{"natural", "tree"}}), ContextKind::tree);
    EXPECT_EQ(widthOfLine(ContextKind::street, {{"highway", "primary"}, {"width", "18.5"}}), 18.5);
}

TEST(ContextKinds, HaveNamesOfTheirOwn) {
    for (const ContextKind kind : contextKinds) EXPECT_EQ(parseContextKind(nameOf(kind)), kind);
    EXPECT_FALSE(parseContextKind("lawn"));
}

TEST(ReadContext, TakesAreasOfAnOpenStreetMapFileWithTheirHoles) {
    const tests::TemporaryFolder folder;
    tests::OsmText osm;
    osm.relation(tests::sizedRectangle(0, 0, 200, 100), {tests::sizedRectangle(50, 20, 40, 30)},
                 {{"leisure", "park"}, {"name", "Square"}});
    osm.way(tests::sizedRectangle(300, 0, 20, 20), {{"building", "yes"}});
    osm.way(tests::sizedRectangle(-100, 0, 60, 40), {{"natural", "water"}});
    const auto file = folder.path("map.osm");
    std::ofstream(file) << osm.xml();
    const auto read = readContextFrom(file);
    ASSERT_TRUE(read) << read.error().text();
    ASSERT_EQ(read->context.areas.size(), 2U);
    EXPECT_THAT(read->context.attribution, HasSubstr("OpenStreetMap"));
    const auto park = std::ranges::find(read->context.areas, "Square", &ContextArea::name);
    ASSERT_NE(park, read->context.areas.end());
    EXPECT_EQ(park->kind, ContextKind::park);
    ASSERT_EQ(park->polygons.size(), 1U);
    EXPECT_EQ(park->polygons[0].holes.size(), 1U);
    EXPECT_NEAR(area(park->polygons[0]), 200 * 100 - 40 * 30, 1);
}

/// A coast from west to east through the middle of a box of 2 km, and a ring of land in the sea.
std::string coastXml(const std::string& bounds, double fromX) {
    const auto node = [](int id, double x, double y) {
        const LonLat at = contextFrame.lonLatFromLocal({x, y});
        return fmt::format("<node id=\"{}\" version=\"1\" lat=\"{:.9f}\" lon=\"{:.9f}\"/>", id, at.latDeg,
                           at.lonDeg);
    };
    const auto way = [](int id, const std::string& nodes) {
        return fmt::format("<way id=\"{}\" version=\"1\">{}<tag k=\"natural\" v=\"coastline\"/></way>", id,
                           nodes);
    };
    return "<?xml version=\"1.0\"?><osm version=\"0.6\">" + bounds + node(1, fromX, 0) + node(2, 0, 0) +
           node(3, 1200, 0) + node(4, 100, -500) + node(5, 300, -500) + node(6, 300, -300) +
           node(7, 100, -300) + way(1, "<nd ref=\"2\"/><nd ref=\"3\"/>") +
           way(2, "<nd ref=\"1\"/><nd ref=\"2\"/>") +
           way(3, "<nd ref=\"4\"/><nd ref=\"5\"/><nd ref=\"6\"/><nd ref=\"7\"/><nd ref=\"4\"/>") + "</osm>";
}

std::string boundsOfTwoKilometres() {
    const LonLat low = contextFrame.lonLatFromLocal({-1000, -1000}),
                 high = contextFrame.lonLatFromLocal({1000, 1000});
    return fmt::format("<bounds minlat=\"{:.9f}\" minlon=\"{:.9f}\" maxlat=\"{:.9f}\" maxlon=\"{:.9f}\"/>",
                       low.latDeg, low.lonDeg, high.latDeg, high.lonDeg);
}

double seaOf(const ContextRead& read) {
    double sum = 0;
    for (const ContextArea& water : read.context.areas)
        if (water.kind == ContextKind::water)
            for (const Footprint& polygon : water.polygons) sum += area(polygon);
    return sum;
}

TEST(ReadContext, ClosesTheSeaAlongTheBoxOfTheFile) {
    const tests::TemporaryFolder folder;
    const auto file = folder.path("coast.osm");
    std::ofstream(file) << coastXml(boundsOfTwoKilometres(), -1200);
    const auto read = readContextFrom(file);
    ASSERT_TRUE(read) << read.error().text();
    EXPECT_NEAR(seaOf(*read), 2000.0 * 1000 - 200 * 200, 500) << "the box of degrees is not quite upright";
    EXPECT_TRUE(read->warnings.empty());
    NoProgress quiet;
    const auto water = readContext(file, {.waterOnly = true}, contextFrame, quiet, {});
    ASSERT_TRUE(water) << water.error().text();
    EXPECT_EQ(water->context.areas, read->context.areas) << "so that its cells are no ground";
}

TEST(ReadContext, SaysThatACoastDoesNotClose) {
    const tests::TemporaryFolder folder;
    const auto file = folder.path("coast.osm");
    std::ofstream(file) << coastXml(boundsOfTwoKilometres(), -500);
    const auto read = readContextFrom(file);
    ASSERT_TRUE(read) << read.error().text();
    EXPECT_EQ(seaOf(*read), 0);
    ASSERT_EQ(read->warnings.size(), 1U);
    EXPECT_THAT(read->warnings[0].what, HasSubstr("does not close"));
    EXPECT_THAT(read->warnings[0].where, HasSubstr("-73.98")) << "where";
}

TEST(ReadContext, ClosesTheSeaAlongTheCoastsOwnBoxWhereTheFileStatesNone) {
    const tests::TemporaryFolder folder;
    const auto file = folder.path("coast.osm");
    std::ofstream(file) << coastXml("", -1200);
    const auto read = readContextFrom(file);
    ASSERT_TRUE(read) << read.error().text();
    EXPECT_NEAR(seaOf(*read), 2400.0 * 500 - 200 * 200, 200);
}

TEST(ReadContext, FindsTheSeaOfMonacoAndTheRiversOfManhattan) {
    const auto monaco = tests::sharedData("monaco/monaco-latest.osm.pbf"),
               midtown = tests::sharedData("midtown_manhattan/midtown_manhattan.osm.pbf");
    if (!monaco || !midtown) GTEST_SKIP() << "needs the shared data";
    NoProgress quiet;
    const auto sea = readContext(*monaco, {.waterOnly = true}, Frame({7.425, 43.737}), quiet, {});
    ASSERT_TRUE(sea) << sea.error().text();
    EXPECT_GT(seaOf(*sea), 3e6);
    const auto rivers = readContext(*midtown, {.waterOnly = true}, contextFrame, quiet, {});
    ASSERT_TRUE(rivers) << rivers.error().text();
    EXPECT_GT(seaOf(*rivers), 5e5);
    for (const auto& read : {sea, rivers})
        for (const Warning& warning : read->warnings)
            EXPECT_EQ(warning.what.find("does not close"), std::string::npos) << warning.where;
}

TEST(ReadContext, TakesKindsAndWidthsOfOtherFiles) {
    const tests::TemporaryFolder folder;
    const auto file = folder.path("map.geojson");
    std::ofstream(file) << R"({"type":"FeatureCollection","features":[
        {"type":"Feature","properties":{"kind":"street","name":"Main","width_m":9},
         "geometry":{"type":"LineString","coordinates":[[-73.98,40.75],[-73.979,40.75]]}},
        {"type":"Feature","properties":{"kind":"tree"},
         "geometry":{"type":"MultiPoint","coordinates":[[-73.98,40.75],[-73.979,40.75]]}},
        {"type":"Feature","properties":{"kind":"chimney"},
         "geometry":{"type":"Point","coordinates":[-73.98,40.75]}},
        {"type":"Feature","properties":{"kind":"street"},
         "geometry":{"type":"LineString","coordinates":[[10,40],[10,41]]}}]})";
    const auto read = readContextFrom(file);
    ASSERT_TRUE(read) << read.error().text();
    ASSERT_EQ(read->context.lines.size(), 1U);
    const ContextLine& street = read->context.lines[0];
    EXPECT_EQ(street.name, "Main");
    EXPECT_EQ(street.widthM, 9);
    // At 40.75 deg north a thousandth of a degree of longitude is 84.4 m.
    EXPECT_NEAR(street.points[1].x - street.points[0].x, 84.4, 0.1);
    EXPECT_EQ(read->context.trees.size(), 2U);
    ASSERT_EQ(read->warnings.size(), 1U);
    EXPECT_THAT(read->warnings[0].what, HasSubstr("too far"));
}

// A lake of some 200 km, whose western shore passes 10 km east of the city, with an island off the city.
TEST(ReadContext, CutsLakesThatReachFarAway) {
    const tests::TemporaryFolder folder;
    const auto file = folder.path("lake.geojson");
    std::ofstream(file) << R"({"type":"FeatureCollection","features":[
        {"type":"Feature","properties":{"kind":"water","name":"Lake"},"geometry":{"type":"Polygon","coordinates":
         [[[-73.862,39.85],[-71.6,39.85],[-71.6,41.65],[-73.862,41.65],[-73.862,39.85]],
          [[-73.8,40.7],[-73.8,40.8],[-73.7,40.8],[-73.7,40.7],[-73.8,40.7]]]}},
        {"type":"Feature","properties":{"kind":"water"},"geometry":{"type":"Polygon","coordinates":
         [[[10,40],[11,40],[11,41],[10,40]]]}}]})";
    const auto read = readContextFrom(file);
    ASSERT_TRUE(read) << read.error().text();
    ASSERT_EQ(read->context.areas.size(), 1U) << "the other is on another continent";
    const Footprint& lake = read->context.areas[0].polygons.at(0);
    EXPECT_TRUE(contains(lake, {30000, 0}));
    EXPECT_TRUE(contains(lake, {59000, 59000}));
    EXPECT_FALSE(contains(lake, {5000, 0}));
    EXPECT_FALSE(contains(lake, {18000, 0})) << "the island";
    EXPECT_LE(bounds(lake).high.x, 60000);
    ASSERT_EQ(read->warnings.size(), 1U);
    EXPECT_THAT(read->warnings[0].where, HasSubstr("1 features"));
}

TEST(ReadContext, RefusesFilesWithNothingToDraw) {
    const tests::TemporaryFolder folder;
    const auto file = folder.path("map.geojson");
    std::ofstream(file) << R"({"type":"FeatureCollection","features":[{"type":"Feature","properties":{},
        "geometry":{"type":"Point","coordinates":[-73.98,40.75]}}]})";
    const auto read = readContextFrom(file);
    ASSERT_FALSE(read);
    EXPECT_THAT(read.error().what, HasSubstr("no streets"));
    EXPECT_FALSE(readContextFrom(folder.path("none.osm")));
}

TEST(ReadContext, IsStopped) {
    const tests::TemporaryFolder folder;
    tests::OsmText osm;
    osm.way(tests::sizedRectangle(0, 0, 10, 10), {{"leisure", "park"}});
    std::ofstream(folder.path("map.osm")) << osm.xml();
    std::stop_source stop;
    stop.request_stop();
    NoProgress quiet;
    const auto read = readContext(folder.path("map.osm"), {}, contextFrame, quiet, stop.get_token());
    ASSERT_FALSE(read);
    EXPECT_TRUE(isCancelled(read.error()));
}

TEST(ReadContext, FindsBryantParkAndFifthAvenue) {
    const auto file = tests::sharedData("midtown_manhattan/midtown_manhattan.osm.pbf");
    if (!file) GTEST_SKIP() << "no shared data";
    const auto read = readContextFrom(*file);
    ASSERT_TRUE(read) << read.error().text();
    const MapContext& context = read->context;
    EXPECT_NE(std::ranges::find(context.areas, "Bryant Park", &ContextArea::name), context.areas.end());
    EXPECT_NE(std::ranges::find(context.lines, "5th Avenue", &ContextLine::name), context.lines.end());
    EXPECT_GT(context.lines.size(), 1000U);
}

}  // namespace

}  // namespace noonmark
