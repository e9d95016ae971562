#include "core/io/places/read_places.h"
#include "core/io/places/place_layer.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/io/places/place_tags.h"
#include "core/receivers/place_names.h"
#include "tests/core/io/osm_text.h"
#include "tests/core/io/temporary_folder.h"
#include "tests/shared/shared_data.h"

namespace noonmark {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

const Frame manhattanFrame({-73.98, 40.75});

Result<PlacesRead> readFrom(const std::filesystem::path& file, const PlaceSettings& settings = {}) {
    NoProgress quiet;
    return readPlaces(file, settings, manhattanFrame, quiet, {});
}

const Place* placeNamed(const PlacesRead& read, std::string_view name) {
    const auto found = std::ranges::find(read.places, name, &Place::name);
    return found == read.places.end() ? nullptr : &*found;
}

std::string osmLine(int firstNode, const std::vector<glm::dvec2>& points, const tests::Tags& tags, int id) {
    std::string nodes, refs, tagTexts;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const LonLat at = manhattanFrame.lonLatFromLocal(points[i]);
        const int node = firstNode + int(i);
        nodes += fmt::format(R"(<node id="{}" version="1" lat="{:.9f}" lon="{:.9f}"/>)", node, at.latDeg,
                             at.lonDeg);
        refs += fmt::format(R"(<nd ref="{}"/>)", node);
    }
    for (const auto& [key, value] : tags) tagTexts += fmt::format(R"(<tag k="{}" v="{}"/>)", key, value);
    return fmt::format(R"({}<way id="{}" version="1">{}{}</way>)", nodes, id, refs, tagTexts);
}

std::string osmOf(const std::string& content) {
    return R"(<?xml version="1.0" encoding="UTF-8"?><osm version="0.6" generator="test">)" + content +
           "</osm>";
}

TEST(PlaceTags, SayWhatKindAnAreaIs) {
    const auto kindOf = [](const PlaceTags& tags) { return classifyArea(tags); };
    EXPECT_EQ(kindOf({{"leisure", "park"}}), PlaceKind::park);
    EXPECT_EQ(kindOf({{"leisure", "pitch"}, {"landuse", "grass"}}), PlaceKind::playground);
    EXPECT_EQ(kindOf({{"leisure", "garden"}}), PlaceKind::greenstreet);
    EXPECT_EQ(kindOf({{"leisure", "garden"}, {"name", "Rose Garden"}}), PlaceKind::park);
    EXPECT_EQ(kindOf({{"amenity", "school"}}), PlaceKind::schoolyard);
    EXPECT_EQ(kindOf({{"landuse", "cemetery"}}), PlaceKind::cemetery);
    EXPECT_EQ(kindOf({{"landuse", "village_green"}}), PlaceKind::park);
    EXPECT_EQ(kindOf({{"place", "square"}}), PlaceKind::plaza);
    EXPECT_EQ(kindOf({{"historic", "memorial"}}), PlaceKind::other);
    EXPECT_FALSE(kindOf({{"natural", "water"}}));
    EXPECT_FALSE(kindOf({{"amenity", "parking"}}));
    EXPECT_FALSE(kindOf({{"amenity", "school"}, {"building", "yes"}}));
    EXPECT_FALSE(kindOf({{"leisure", "park"}, {"layer", "-1"}}));
}

TEST(PlaceTags, GiveAStreetItsWidth) {
    const auto widthOf = [](const PlaceTags& tags) { return readStreetWidth(tags); };
    EXPECT_EQ(widthOf({{"highway", "primary"}, {"width", "18.5"}, {"lanes", "4"}})->widthM, 18.5);
    EXPECT_NEAR(widthOf({{"highway", "primary"}, {"width", "30'"}})->widthM, 9.144, 1e-9);
    const auto byLanes = widthOf({{"highway", "residential"}, {"lanes", "3"}});
    EXPECT_NEAR(byLanes->widthM, 9.6, 1e-9);
    EXPECT_FALSE(byLanes->assumed);
    const auto byClass = widthOf({{"highway", "residential"}, {"width", "wide"}, {"lanes", "0"}});
    EXPECT_EQ(byClass->widthM, 8);
    EXPECT_TRUE(byClass->assumed);
    EXPECT_EQ(widthOf({{"highway", "tertiary"}, {"width", "1e9"}})->widthM, 10);
    EXPECT_FALSE(widthOf({{"highway", "footway"}}));
    EXPECT_FALSE(widthOf({{"highway", "primary"}, {"tunnel", "yes"}}));
}

class ReadPlaces : public testing::Test {
protected:
    tests::TemporaryFolder folder_;
};

TEST_F(ReadPlaces, AreasOfOpenStreetMapWithTheirHolesNamesAndSources) {
    tests::OsmText osm;
    osm.way(tests::sizedRectangle(0, 0, 100, 50), {{"leisure", "park"}, {"name", "Green"}});
    const std::string ring =
        osm.relation(tests::sizedRectangle(200, 0, 100, 100), {tests::sizedRectangle(240, 40, 20, 20)},
                     {{"landuse", "cemetery"}, {"name", "Yard"}});
    const std::string bare = osm.way(tests::sizedRectangle(400, 0, 10, 10), {{"leisure", "playground"}});
    osm.way(tests::sizedRectangle(500, 0, 10, 10), {{"building", "yes"}, {"leisure", "park"}});
    osm.way(tests::sizedRectangle(600, 0, 10, 10), {{"natural", "water"}});
    const auto read = readFrom(folder_.file("a.osm", osm.xml())).value();
    ASSERT_EQ(read.places.size(), 3U);
    const Place* yard = placeNamed(read, "Yard");
    ASSERT_NE(yard, nullptr);
    EXPECT_EQ(yard->kind, PlaceKind::cemetery);
    EXPECT_EQ(yard->source, "OSM " + ring);
    EXPECT_NEAR(area(*yard), 100 * 100 - 20 * 20, 0.5);
    EXPECT_NEAR(area(*placeNamed(read, "Green")), 5000, 0.5);
    EXPECT_NE(placeNamed(read, fmt::format("playground (OSM {})", bare)), nullptr);
    EXPECT_THAT(read.attribution, HasSubstr("OpenStreetMap"));
}

TEST_F(ReadPlaces, PiecesOfOneNameJoinWhereTheyLieNearEachOther) {
    tests::OsmText osm;
    for (const float west : {0.0F, 120.0F, 2000.0F})
        osm.way(tests::sizedRectangle(west, 0, 100, 10), {{"leisure", "park"}, {"name", "Malls"}});
    osm.way(tests::sizedRectangle(90, 0, 20, 10), {{"leisure", "park"}, {"name", "Malls"}});
    const auto read = readFrom(folder_.file("a.osm", osm.xml())).value();
    ASSERT_EQ(read.places.size(), 2U);
    EXPECT_NEAR(area(*placeNamed(read, "Malls")), 2100, 1);  // 10 m of the fourth lie in the first
    EXPECT_EQ(placeNamed(read, "Malls")->source, "OSM way 1 and 2 more");
    EXPECT_NE(placeNamed(read, "Malls (2)"), nullptr);
}

// Two ways of 100 m that meet at a right angle, 12 m wide: 2 x 100 x 12, less the square where they overlap,
// plus the quarter of a circle around the bend (a 16-gon's quarter).
TEST_F(ReadPlaces, StreetsAreAsWideAsTaggedAndJoinedByName) {
    const tests::Tags tagged{{"highway", "primary"}, {"name", "Main Street"}, {"width", "12"}};
    const std::string text =
        osmLine(1, {{0, 0}, {100, 0}}, tagged, 1) + osmLine(10, {{100, 0}, {100, 100}}, tagged, 2) +
        osmLine(20, {{500, 0}, {600, 0}}, {{"highway", "residential"}, {"name", "Side Street"}}, 3) +
        osmLine(30, {{700, 0}, {800, 0}}, {{"highway", "steps"}, {"name", "Steps"}}, 4);
    const auto file = folder_.file("a.osm", osmOf(text));
    EXPECT_TRUE(readFrom(file).value().places.empty());
    const auto read = readFrom(file, {.streets = true}).value();
    ASSERT_EQ(read.places.size(), 2U);
    const double quarter = 4 * 36 * std::sin(3.14159265358979 / 8) / 2;
    EXPECT_NEAR(area(*placeNamed(read, "Main Street")), 2 * 1200 - 36 + quarter, 1);
    EXPECT_NEAR(area(*placeNamed(read, "Side Street")), 800, 0.5);
    EXPECT_EQ(read.streetsOfAssumedWidth, 1U);
    EXPECT_EQ(placeNamed(read, "Side Street")->kind, PlaceKind::street);
}

// Main Street, 12 m wide and 100 m long, is crossed in its middle by Cross Street, 8 m wide: its two
// sidewalks of 3 m lose 8 m each. Cross Street's lose the 12 m of Main Street; the corners belong to both.
TEST_F(ReadPlaces, SidewalksLieBesideTheCarriagewaysOfAllStreets) {
    const std::string text = osmLine(1, {{0, 0}, {100, 0}},
                                     {{"highway", "primary"}, {"name", "Main Street"}, {"width", "12"}}, 1) +
                             osmLine(10, {{50, -50}, {50, 50}},
                                     {{"highway", "tertiary"}, {"name", "Cross Street"}, {"width", "8"}}, 2);
    const auto file = folder_.file("a.osm", osmOf(text));
    const auto read = readFrom(file, {.streets = true, .sidewalkM = 3}).value();
    ASSERT_EQ(read.places.size(), 4U);
    EXPECT_NEAR(area(*placeNamed(read, "Main Street, carriageway")), 12 * 100, 1);
    EXPECT_NEAR(area(*placeNamed(read, "Main Street, sidewalks")), 2 * 3 * (100 - 8), 1);
    EXPECT_NEAR(area(*placeNamed(read, "Cross Street, sidewalks")), 2 * 3 * (100 - 12), 1);
    EXPECT_EQ(placeNamed(read, "Main Street, sidewalks")->polygons.size(), 4U);
}

std::vector<std::string> namesOf(const PlacesRead& read) {
    std::vector<std::string> names;
    for (const Place& place : read.places) names.push_back(place.name);
    return names;
}

std::string street(int node, const std::vector<glm::dvec2>& line, const std::string& name, int way) {
    return osmLine(node, line, {{"highway", "residential"}, {"name", name}, {"width", "10"}}, way);
}

std::vector<std::string> blocksOf(tests::TemporaryFolder& folder, const std::string& text) {
    return namesOf(
        readFrom(folder.file("blocks.osm", osmOf(text)), {.streets = true, .wholeStreets = false}).value());
}

// 46th Street is crossed by 5th and 10th Avenue, in one way of four points and beyond both. Numbers count,
// not letters: 10th comes after 5th.
TEST_F(ReadPlaces, StreetsAreCutAtTheirCrossStreets) {
    const std::string text = street(1, {{0, 0}, {100, 0}, {300, 0}, {400, 0}}, "46th Street", 1) +
                             street(10, {{100, -80}, {100, 0}, {100, 90}}, "10th Avenue", 2) +
                             street(20, {{300, -80}, {300, 0}, {300, 90}}, "5th Avenue", 3);
    const auto file = folder_.file("a.osm", osmOf(text));
    const auto read = readFrom(file, {.streets = true, .wholeStreets = false}).value();
    EXPECT_THAT(namesOf(read),
                ElementsAre("5th Avenue, north of 46th Street", "5th Avenue, south of 46th Street",
                            "10th Avenue, north of 46th Street", "10th Avenue, south of 46th Street",
                            "46th Street, 5th Avenue to 10th Avenue", "46th Street, east of 5th Avenue",
                            "46th Street, west of 10th Avenue"));
    EXPECT_NEAR(area(*placeNamed(read, "46th Street, 5th Avenue to 10th Avenue")), 200 * 10, 1);
}

// The avenue's carriageways lie 20 m apart; the street between them belongs to one of the blocks beside it.
TEST_F(ReadPlaces, DualCarriagewaysAreOneStreet) {
    const std::string text = street(1, {{-100, 0}, {0, 0}, {20, 0}, {120, 0}}, "1st Street", 1) +
                             street(10, {{-100, 100}, {0, 100}, {20, 100}, {120, 100}}, "2nd Street", 2) +
                             street(20, {{0, 0}, {0, 100}}, "Park Avenue", 3) +
                             street(30, {{20, 0}, {20, 100}}, "Park Avenue", 4);
    const auto file = folder_.file("a.osm", osmOf(text));
    const auto read = readFrom(file, {.streets = true, .wholeStreets = false}).value();
    ASSERT_THAT(namesOf(read), testing::Contains("Park Avenue, 1st Street to 2nd Street"));
    EXPECT_EQ(read.places.size(), 5U) << "no block between the carriageways";
    const Place& avenue = *placeNamed(read, "Park Avenue, 1st Street to 2nd Street");
    EXPECT_NEAR(area(avenue), 2 * 100 * 10, 1);
    EXPECT_EQ(avenue.polygons.size(), 2U);
    double streets = 0;
    for (const Place& place : read.places) streets += area(place);
    EXPECT_NEAR(streets, (220 + 220 + 200) * 10, 1);
}

// The circle is a street of its own; the lane without a name is listed and cuts nothing; the bridge crosses
// without a point in common.
TEST_F(ReadPlaces, CirclesLanesAndBridgesAreListedToo) {
    const std::string text =
        street(1, {{0, 0}, {30, 30}, {60, 0}, {30, -30}, {0, 0}}, "The Circle", 1) +
        street(10, {{60, 0}, {100, 0}, {200, 0}}, "East Road", 2) +
        street(20, {{0, 0}, {-100, 0}}, "West Road", 3) +
        osmLine(30, {{100, 0}, {100, 50}}, {{"highway", "residential"}, {"width", "5"}}, 4) +
        street(40, {{150, -50}, {150, 50}}, "Bridge", 5);
    EXPECT_THAT(blocksOf(folder_, text),
                ElementsAre("street (OSM way 4)", "Bridge", "East Road, east of The Circle",
                            "The Circle, East Road to West Road", "West Road, west of The Circle"));
}

TEST_F(ReadPlaces, ACrescentEndsTwiceAtTheSameStreet) {
    const std::string text = street(1, {{0, 0}, {100, 0}}, "Main Street", 1) +
                             street(10, {{0, 0}, {50, 80}, {100, 0}}, "The Crescent", 2);
    EXPECT_THAT(blocksOf(folder_, text),
                ElementsAre("Main Street, at The Crescent", "The Crescent, at Main Street"));
}

constexpr const char* parksGeoJson = R"({"type":"FeatureCollection","features":[
{"type":"Feature","properties":{"signname":"Bryant Park"},"geometry":{"type":"Polygon","coordinates":[[[-73.98,40.75],[-73.979,40.75],[-73.979,40.751],[-73.98,40.751],[-73.98,40.75]]]}},
{"type":"Feature","properties":{"signname":"Yard","kind":"schoolyard"},"geometry":{"type":"Polygon","coordinates":[[[-73.97,40.75],[-73.969,40.751],[-73.969,40.75],[-73.97,40.751],[-73.97,40.75]]]}},
{"type":"Feature","properties":{"signname":"Far"},"geometry":{"type":"Polygon","coordinates":[[[10,50],[10.1,50],[10.1,50.1],[10,50]]]}},
{"type":"Feature","properties":{"signname":"Point"},"geometry":{"type":"Point","coordinates":[-73.98,40.75]}}]})";

TEST_F(ReadPlaces, PolygonsOfAnyFileWithANameField) {
    const auto file = folder_.file("parks.geojson", parksGeoJson);
    const auto read = readFrom(file, {.kind = PlaceKind::plaza}).value();
    ASSERT_EQ(read.places.size(), 2U);
    EXPECT_EQ(placeNamed(read, "Bryant Park")->kind, PlaceKind::plaza);
    EXPECT_EQ(placeNamed(read, "Bryant Park")->source, "parks.geojson, feature 0");
    EXPECT_EQ(placeNamed(read, "Yard")->kind, PlaceKind::schoolyard);
    ASSERT_EQ(read.warnings.size(), 2U);  // the bow tie is mended, the one in Germany left out
    EXPECT_EQ(readFrom(file, {.kinds = {PlaceKind::schoolyard}}).value().places.size(), 1U);
    EXPECT_TRUE(readFrom(file, {.minAreaM2 = 1e6}).value().places.empty());
}

TEST_F(ReadPlaces, WhatIsWrongWithAFileIsReported) {
    EXPECT_THAT(readFrom(folder_.path("none.gpkg")).error().text(), HasSubstr("none.gpkg"));
    EXPECT_THAT(readFrom(folder_.file("a.geojson", parksGeoJson), {.nameField = "title"}).error().text(),
                HasSubstr("signname"));
    EXPECT_THAT(readFrom(folder_.file("b.geojson", parksGeoJson), {.layer = "lots"}).error().text(),
                HasSubstr("There is no layer"));
    EXPECT_FALSE(readFrom(folder_.file("c.geojson", "{}")));
    EXPECT_FALSE(
        readFrom(folder_.file("d.osm", "<?xml version=\"1.0\"?><osm version=\"0.6\"><way id=\"1\">")));
    EXPECT_FALSE(readFrom(folder_.file(
        "e.vrt", R"(<OGRVRTDataSource><OGRVRTLayer name="a"><SrcDataSource>/etc/passwd</SrcDataSource>)")));
}

// Degrees of longitude are 84.4 km long there, those of latitude 111: lines of 84.4 and 111 m.
TEST_F(ReadPlaces, LinesOfALayerAreStreetsAsWideAsStated) {
    const auto file = folder_.file("streets.geojson", R"({"type":"FeatureCollection","features":[
{"type":"Feature","properties":{"NAME":"Long Lane","Width":"10"},"geometry":{"type":"LineString","coordinates":[[-73.98,40.75],[-73.98,40.751]]}},
{"type":"Feature","properties":{"NAME":"Cross Lane"},"geometry":{"type":"MultiLineString","coordinates":[[[-73.98,40.75],[-73.979,40.75]]]}}]})");
    const auto read = readFrom(file, {.kinds = {PlaceKind::street}, .streets = true}).value();
    ASSERT_EQ(read.places.size(), 2U);
    EXPECT_EQ(placeNamed(read, "Long Lane")->kind, PlaceKind::street);
    EXPECT_THAT(placeNamed(read, "Long Lane")->source, HasSubstr("streets.geojson, "));
    EXPECT_NEAR(area(*placeNamed(read, "Long Lane")), 111 * 10, 10);
    EXPECT_NEAR(area(*placeNamed(read, "Cross Lane")), 84.4 * 8, 10) << "as wide as residential streets";
    EXPECT_EQ(read.streetsOfAssumedWidth, 1U);
    EXPECT_THAT(readFrom(file).error().text(), HasSubstr("lines can be read as streets"));
}

TEST_F(ReadPlaces, OfSeveralLayersTheUserNamesOne) {
    const auto square = [](double west) {
        return fmt::format(
            "<Polygon><outerBoundaryIs><LinearRing><coordinates>{0},40.75 {1},40.75 {1},40.751 "
            "{0},40.751 {0},40.75</coordinates></LinearRing></outerBoundaryIs></Polygon>",
            west, west + 0.001);
    };
    const auto layer = [&](const char* name, double west) {
        return fmt::format("<Folder><name>{0}</name><Placemark><name>{0} 1</name>{1}</Placemark></Folder>",
                           name, square(west));
    };
    const auto kml = [](const std::string& layers) {
        return R"(<kml xmlns="http://www.opengis.net/kml/2.2"><Document>)" + layers + "</Document></kml>";
    };
    const auto unknown = folder_.file("unknown.kml", kml(layer("houses", -73.98) + layer("lawns", -73.97)));
    EXPECT_THAT(readFrom(unknown).error().text(), HasSubstr("houses, lawns"));
    const auto asked = readFrom(unknown, {.listLayers = true}).value().layers;
    ASSERT_EQ(asked.size(), 2U);
    EXPECT_EQ(asked[1].name, "lawns");
    EXPECT_EQ(asked[1].features, 1U);
    EXPECT_THAT(asked[1].textFields, testing::Contains("Name"));
    EXPECT_EQ(readFrom(unknown, {.layer = "lawns"}).value().places.front().name, "lawns 1");
    EXPECT_TRUE(readFrom(unknown, {.layer = "lawns"}).value().warnings.empty()) << "the other was not wanted";
    EXPECT_NE(readFrom(unknown, {.layer = "lawns"}).value().places.front().source,
              readFrom(unknown, {.layer = "houses"}).value().places.front().source)
        << "neither replaces the other";
    const auto chosen = readFrom(unknown, {.layer = "lawns", .listLayers = true}).value();
    EXPECT_TRUE(chosen.layers.empty()) << "it is chosen";
    EXPECT_EQ(chosen.places.size(), 1U);
    const auto alone = readFrom(folder_.file("parks.geojson", parksGeoJson), {.listLayers = true}).value();
    EXPECT_TRUE(alone.layers.empty()) << "there is one";
    EXPECT_FALSE(alone.places.empty());
}

TEST_F(ReadPlaces, AFileCutOffAnywhereGivesAnErrorOrFewerPlaces) {
    tests::OsmText osm;
    for (int i = 0; i < 5; ++i)
        osm.way(tests::sizedRectangle(float(i) * 50, 0, 40, 40), {{"leisure", "park"}});
    const std::string whole = osm.xml();
    for (std::size_t bytes = 0; bytes < whole.size(); bytes += 97) {
        const auto read = readFrom(folder_.file("cut.osm", whole.substr(0, bytes)), {.streets = true});
        EXPECT_LE(read ? read->places.size() : 0U, 5U);
    }
}

TEST_F(ReadPlaces, StopsWhenAsked) {
    tests::OsmText osm;
    for (int i = 0; i < 600; ++i)
        osm.way(tests::sizedRectangle(float(i) * 50, 0, 40, 40), {{"leisure", "park"}});
    NoProgress quiet;
    std::stop_source source;
    source.request_stop();
    const auto read =
        readPlaces(folder_.file("a.osm", osm.xml()), {}, manhattanFrame, quiet, source.get_token());
    ASSERT_FALSE(read);
    EXPECT_TRUE(isCancelled(read.error()));
}

// Bryant Park's lot is 39,000 m2 with the library's terrace; the park as mapped has 30,000 to 40,000.
TEST(ReadMidtownPlaces, KnownParksAndStreets) {
    const auto file = tests::sharedData("midtown_manhattan/midtown_manhattan.osm.pbf");
    if (!file) GTEST_SKIP() << "the shared Midtown extract is missing";
    const auto read = readFrom(*file, {.streets = true}).value();
    const Place bryant = findPlace(read.places, "Bryant Park").value();
    EXPECT_EQ(bryant.kind, PlaceKind::park);
    EXPECT_GT(area(bryant), 15000);
    EXPECT_LT(area(bryant), 42000);
    EXPECT_EQ(findPlace(read.places, "Madison Square Park").value().kind, PlaceKind::park);
    EXPECT_EQ(findPlace(read.places, "West 42nd Street").value().kind, PlaceKind::street);
    EXPECT_GT(std::ranges::count(read.places, PlaceKind::park, &Place::kind), 40);
    EXPECT_GT(std::ranges::count(read.places, PlaceKind::street, &Place::kind), 60);
    EXPECT_GT(read.streetsOfAssumedWidth, 0U);
}

}  // namespace
}  // namespace noonmark
