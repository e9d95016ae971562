#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <algorithm>

#include "core/io/footprints/build_footprints.h"
#include "core/io/osm/read_osm_buildings.h"
#include "core/io/pieces/read_part.h"
#include "tests/core/io/osm_text.h"
#include "tests/core/io/temporary_folder.h"

namespace noonmark {

namespace {

TEST(MapRemarks, AreInAPlannersWords) {
    EXPECT_THAT(explainGdalWarning("Non closed ring detected. To avoid accepting it, set ... to NO"),
                testing::HasSubstr("were not closed"));
    EXPECT_THAT(
        explainGdalWarning("organizePolygons() received an unexpected geometry.  Either a polygon ..."),
        testing::HasSubstr("could not be distinguished"));
    EXPECT_EQ(explainGdalWarning(
                  "organizePolygons() received a polygon with more than 100 parts. The processing may be "
                  "really slow."),
              "");
    EXPECT_THAT(explainGdalWarning("Something new"), testing::HasSubstr("Something new"));
}

constexpr std::string_view oneClosedOneOpen =
    R"({"type":"FeatureCollection","features":[
{"type":"Feature","properties":{"id":"closed","height":30},"geometry":{"type":"Polygon","coordinates":
[[[-73.98,40.75],[-73.9799,40.75],[-73.9799,40.7501],[-73.98,40.7501],[-73.98,40.75]]]}},
{"type":"Feature","properties":{"id":"open","height":30},"geometry":{"type":"Polygon","coordinates":
[[[-73.98,40.751],[-73.9799,40.751],[-73.9799,40.7511],[-73.98,40.7511]]]}}]})";

TEST(MapRemarks, AnOutlineThatDoesNotCloseIsReadAndReported) {
    const tests::TemporaryFolder folder;
    NoProgress quiet;
    const auto piece = readFootprints(folder.file("a.geojson", oneClosedOneOpen), {}, quiet, {});
    ASSERT_TRUE(piece) << piece.error().text();
    EXPECT_EQ(piece->buildings.size(), 2U);
    const auto said = std::ranges::find(piece->warnings, "a.geojson (1)", &Warning::where);
    ASSERT_NE(said, piece->warnings.end());
    EXPECT_EQ(said->kind, WarningKind::repaired);
    EXPECT_THAT(said->what, testing::HasSubstr("were not closed"));
}

using testing::ElementsAre;
using testing::HasSubstr;
using testing::UnorderedElementsAre;
using tests::sizedRectangle;
using tests::Tags;

class OsmSemantics : public testing::Test {
protected:
    FilePiece read() {
        NoProgress quiet;
        auto result = readOsmFootprints(folder.file("test.osm", osm.xml()), settings, quiet, {});
        EXPECT_TRUE(result) << result.error().text();
        return result ? *std::move(result) : FilePiece();
    }
    Building only() {
        piece = read();
        EXPECT_EQ(piece.buildings.size(), 1U);
        return piece.buildings.empty() ? Building() : *piece.buildings[0];
    }
    [[nodiscard]] std::vector<std::string> placesOf(std::string_view what) const {
        std::vector<std::string> places;
        for (const Warning& warning : piece.warnings)
            if (warning.what.find(what) != std::string::npos) places.push_back(warning.where);
        return places;
    }

    tests::TemporaryFolder folder;
    tests::OsmText osm;
    ReadSettings settings;
    FilePiece piece;
};

std::vector<std::string> idsOf(const Building& building) {
    std::vector<std::string> ids;
    for (const Part& part : building.parts) ids.push_back(part.sourceId);
    return ids;
}

const Part& cutInterval(const Building& building, const std::string& id) {
    static const Part none;
    const auto found = std::ranges::find(building.parts, id, &Part::sourceId);
    EXPECT_NE(found, building.parts.end()) << id;
    return found == building.parts.end() ? none : *found;
}

double computeArea(const Building& building, const std::string& id) {
    double sum = 0;
    for (const Part& part : building.parts)
        if (part.sourceId == id) sum += area(part.footprint);
    return sum;
}

TEST_F(OsmSemantics, ABuildingIsItsOutline) {
    const auto way =
        osm.way(sizedRectangle(0, 0, 20, 10), {{"building", "yes"}, {"height", "30 ft"}, {"name", "Shed"}});
    const Building building = only();
    EXPECT_EQ(building.sourceId, way);
    EXPECT_EQ(building.name, "Shed");
    ASSERT_THAT(idsOf(building), ElementsAre(way));
    EXPECT_NEAR(building.parts[0].topM, 9.144, 1e-4);
    EXPECT_NEAR(area(building.parts[0].footprint), 200, 0.1);
    EXPECT_EQ(building.parts[0].heightSource, HeightSource::measured);
    EXPECT_FALSE(building.parts[0].isOverhanging);
    EXPECT_TRUE(piece.warnings.empty());
    EXPECT_THAT(piece.attribution, HasSubstr("OpenStreetMap contributors"));
    EXPECT_EQ(piece.format, "OpenStreetMap XML");
}

TEST_F(OsmSemantics, CourtyardsStayOpen) {
    const auto id =
        osm.relation(sizedRectangle(0, 0, 40, 40), {sizedRectangle(10, 10, 20, 20)}, {{"building", "yes"}});
    const Building building = only();
    EXPECT_EQ(building.sourceId, id);
    EXPECT_NEAR(area(building.parts[0].footprint), 1200, 0.5);
}

TEST_F(OsmSemantics, PartsReplaceTheirOutline) {
    const auto outline = osm.way(sizedRectangle(0, 0, 40, 20), {{"building", "yes"}, {"height", "90"}});
    const auto low = osm.way(sizedRectangle(0, 0, 20, 20), {{"building:part", "yes"}, {"height", "20"}});
    const auto high = osm.way(sizedRectangle(20, 0, 20, 20), {{"building:part", "yes"}, {"height", "90"}});
    const Building building = only();
    EXPECT_EQ(building.sourceId, outline);
    EXPECT_THAT(idsOf(building), UnorderedElementsAre(low, high));
    EXPECT_FLOAT_EQ(cutInterval(building, low).topM, 20);
    EXPECT_FLOAT_EQ(cutInterval(building, high).topM, 90);
}

TEST_F(OsmSemantics, PartsOfATallerBuildingLeaveTheRestAsHighAsTheLowest) {
    const auto outline = osm.way(sizedRectangle(0, 0, 60, 20), {{"building", "yes"}, {"height", "200"}});
    osm.way(sizedRectangle(0, 0, 20, 20), {{"building:part", "yes"}, {"height", "200"}});
    osm.way(sizedRectangle(20, 0, 20, 20), {{"building:part", "yes"}, {"height", "25"}});
    const Building building = only();
    EXPECT_NEAR(computeArea(building, outline), 400, 0.5);
    EXPECT_FLOAT_EQ(cutInterval(building, outline).topM, 25);
    EXPECT_EQ(cutInterval(building, outline).heightSource, HeightSource::assumed);
    EXPECT_THAT(placesOf("leave some of its outline uncovered"), ElementsAre(outline));
}

TEST_F(OsmSemantics, AnOutlineLowerThanItsPartsKeepsItsHeightWhereUncovered) {
    const auto outline = osm.way(sizedRectangle(0, 0, 60, 20), {{"building", "yes"}, {"height", "20"}});
    osm.way(sizedRectangle(0, 0, 20, 20), {{"building:part", "yes"}, {"height", "120"}});
    const Building building = only();
    EXPECT_NEAR(computeArea(building, outline), 800, 0.5);
    EXPECT_FLOAT_EQ(cutInterval(building, outline).topM, 20);
    EXPECT_EQ(cutInterval(building, outline).heightSource, HeightSource::measured);
    EXPECT_TRUE(placesOf("uncovered").empty());
}

TEST_F(OsmSemantics, APartThatBeginsAboveTheOutlineReplacesNothing) {
    const auto podium = osm.way(sizedRectangle(0, 0, 40, 40), {{"building", "yes"}, {"height", "20"}});
    const auto tower = osm.way(sizedRectangle(10, 10, 20, 20),
                               {{"building:part", "yes"}, {"height", "100"}, {"min_height", "20"}});
    const Building building = only();
    EXPECT_NEAR(computeArea(building, podium), 1600, 0.5);
    EXPECT_FALSE(cutInterval(building, tower).isOverhanging);
    EXPECT_FLOAT_EQ(cutInterval(building, tower).bottomM, 20);
}

TEST_F(OsmSemantics, SliversOfOutlineAreNoBuilding) {
    osm.way(sizedRectangle(0, 0, 40, 20), {{"building", "yes"}, {"height", "90"}});
    const auto part = osm.way(sizedRectangle(0, 0, 39.5F, 20), {{"building:part", "yes"}, {"height", "90"}});
    EXPECT_THAT(idsOf(only()), ElementsAre(part));
}

TEST_F(OsmSemantics, AnOutlineThatIsItselfAPartStands) {
    const auto both = osm.way(sizedRectangle(0, 0, 40, 40),
                              {{"building", "yes"}, {"building:part", "yes"}, {"height", "20"}});
    const auto tower = osm.way(sizedRectangle(10, 10, 10, 10), {{"building:part", "yes"}, {"height", "80"}});
    const Building building = only();
    EXPECT_THAT(idsOf(building), UnorderedElementsAre(both, tower));
    EXPECT_NEAR(computeArea(building, both), 1600, 0.5);
}

TEST_F(OsmSemantics, PartsWithoutAnOutlineStandForThemselves) {
    const auto base = osm.way(sizedRectangle(0, 0, 60, 60), {{"building:part", "yes"}, {"height", "320"}});
    const auto middle = osm.way(sizedRectangle(10, 10, 40, 40),
                                {{"building:part", "yes"}, {"min_height", "320"}, {"height", "390"}});
    const auto mast = osm.way(sizedRectangle(28, 28, 4, 4),
                              {{"building:part", "yes"}, {"min_height", "390"}, {"height", "443.2"}});
    const auto elsewhere =
        osm.way(sizedRectangle(200, 0, 10, 10), {{"building:part", "yes"}, {"height", "10"}});
    piece = read();
    ASSERT_EQ(piece.buildings.size(), 2U);
    EXPECT_EQ(piece.buildings[0]->sourceId, base);
    EXPECT_THAT(idsOf(*piece.buildings[0]), ElementsAre(base, middle, mast));
    EXPECT_FLOAT_EQ(topM(*piece.buildings[0]), 443.2F);
    for (const Part& part : piece.buildings[0]->parts) EXPECT_FALSE(part.isOverhanging);
    EXPECT_THAT(idsOf(*piece.buildings[1]), ElementsAre(elsewhere));
}

TEST_F(OsmSemantics, BuildingsThatShareAPartyWallStayTwo) {
    const auto west = osm.way(sizedRectangle(0, 0, 10, 20), {{"building", "yes"}, {"height", "90"}});
    const auto east = osm.way(sizedRectangle(10, 0, 10, 20), {{"building", "yes"}, {"height", "90"}});
    const auto westPart =
        osm.way(sizedRectangle(0, 0, 10.02F, 20), {{"building:part", "yes"}, {"height", "15"}});
    const auto eastPart =
        osm.way(sizedRectangle(10, 0, 10, 20), {{"building:part", "yes"}, {"height", "25"}});
    piece = read();
    ASSERT_EQ(piece.buildings.size(), 2U);
    EXPECT_EQ(piece.buildings[0]->sourceId, west);
    EXPECT_THAT(idsOf(*piece.buildings[0]), ElementsAre(westPart));
    EXPECT_EQ(piece.buildings[1]->sourceId, east);
    EXPECT_THAT(idsOf(*piece.buildings[1]), ElementsAre(eastPart));
}

TEST_F(OsmSemantics, APartBelongsToTheSmallestOutlineAroundIt) {
    osm.way(sizedRectangle(0, 0, 100, 100), {{"building", "yes"}, {"height", "9"}});
    const auto inner = osm.way(sizedRectangle(20, 20, 30, 30), {{"building", "yes"}, {"height", "40"}});
    const auto part = osm.way(sizedRectangle(20, 20, 30, 30), {{"building:part", "yes"}, {"height", "50"}});
    piece = read();
    ASSERT_EQ(piece.buildings.size(), 2U);
    EXPECT_EQ(piece.buildings[1]->sourceId, inner);
    EXPECT_THAT(idsOf(*piece.buildings[1]), ElementsAre(part));
}

TEST_F(OsmSemantics, MinHeightLiftsAndWhatIsOpenBelowHangs) {
    osm.way(sizedRectangle(0, 0, 30, 10), {{"building", "yes"}, {"height", "30"}});
    const auto leg = osm.way(sizedRectangle(0, 0, 10, 10), {{"building:part", "yes"}, {"height", "30"}});
    const auto bridge = osm.way(sizedRectangle(10, 0, 20, 10),
                                {{"building:part", "yes"}, {"height", "30"}, {"building:min_level", "4"}});
    const Building building = only();
    EXPECT_FALSE(cutInterval(building, leg).isOverhanging);
    EXPECT_TRUE(cutInterval(building, bridge).isOverhanging);
    EXPECT_FLOAT_EQ(cutInterval(building, bridge).bottomM, 12.8F);
}

TEST_F(OsmSemantics, WhatStandsOnSomethingThatHangsHangs) {
    const auto slab = osm.way(sizedRectangle(0, 0, 30, 10),
                              {{"building:part", "yes"}, {"height", "30"}, {"min_height", "20"}});
    const auto top = osm.way(sizedRectangle(5, 0, 20, 10),
                             {{"building:part", "yes"}, {"height", "50"}, {"min_height", "30"}});
    const Building building = only();
    EXPECT_TRUE(cutInterval(building, slab).isOverhanging);
    EXPECT_TRUE(cutInterval(building, top).isOverhanging);
}

TEST_F(OsmSemantics, ASlitOfLessThanAStoreyIsClosedAndReported) {
    osm.way(sizedRectangle(0, 0, 30, 30), {{"building:part", "yes"}, {"height", "17"}});
    const auto upper = osm.way(sizedRectangle(5, 5, 20, 20),
                               {{"building:part", "yes"}, {"height", "75"}, {"min_height", "20"}});
    const Building building = only();
    EXPECT_FLOAT_EQ(cutInterval(building, upper).bottomM, 17);
    EXPECT_FALSE(cutInterval(building, upper).isOverhanging);
    EXPECT_THAT(placesOf("low gap"), ElementsAre(upper));
}

// Chicago's Marina City stands on a deck, and its towers are mapped below the layer of the street.
TEST_F(OsmSemantics, ALayerBelow0DoesNotBuryATower) {
    const auto marinaCity = osm.way(sizedRectangle(0, 0, 30, 30), {{"building:part", "yes"},
                                                                   {"building:levels", "61"},
                                                                   {"height", "167"},
                                                                   {"layer", "-1"},
                                                                   {"min_height", "55"},
                                                                   {"name", "Marina City"}});
    const auto shop = osm.way(sizedRectangle(100, 0, 10, 10),
                              {{"building", "retail"}, {"layer", "-1"}, {"location", "surface"}});
    const auto door =
        osm.way(sizedRectangle(200, 0, 10, 10), {{"building", "yes"}, {"layer", "-1"}, {"entrance", "main"}});
    const auto bare = osm.way(sizedRectangle(400, 0, 10, 10), {{"building", "yes"}, {"layer", "-1"}});
    for (const Tags& buried : std::vector<Tags>{{{"layer", "-2"}},
                                                {{"layer", "-1"}, {"building:levels", "0"}},
                                                {{"level", "-2"}},
                                                {{"tunnel", "yes"}},
                                                {{"location", "underground"}, {"height", "12"}}}) {
        Tags tags = buried;
        tags.emplace_back("building", "yes");
        osm.way(sizedRectangle(300, 0, 10, 10), tags);
    }
    piece = read();
    std::vector<std::string> ids;
    for (const auto& building : piece.buildings) ids.push_back(building->sourceId);
    EXPECT_THAT(ids, UnorderedElementsAre(marinaCity, shop, door, bare));
    EXPECT_THAT(placesOf("underground"), testing::SizeIs(5));
    EXPECT_THAT(placesOf("layer lies below the ground"), ElementsAre(marinaCity, shop, door, bare));
    const auto tower =
        std::ranges::find(piece.buildings, marinaCity, [](const auto& b) { return b->sourceId; });
    ASSERT_NE(tower, piece.buildings.end());
    EXPECT_EQ((*tower)->parts[0].topM, 167);
    EXPECT_EQ((*tower)->parts[0].bottomM, 55);
}

// A storey that begins at the first, with a roof of 2.2 m below 5 m: its walls have no height.
TEST_F(OsmSemantics, AnUndersideCountedInStoreysIsAtMostAtTheEaves) {
    const auto passage = osm.way(sizedRectangle(0, 0, 10, 10), {{"building:part", "yes"},
                                                                {"building:levels", "1"},
                                                                {"building:min_level", "1"},
                                                                {"height", "5"},
                                                                {"roof:height", "2.2"}});
    const Building building = only();
    EXPECT_NEAR(cutInterval(building, passage).bottomM, 2.8, 1e-4);
    EXPECT_TRUE(cutInterval(building, passage).isOverhanging);
    EXPECT_EQ(cutInterval(building, passage).topM, 5);
}

TEST_F(OsmSemantics, UndergroundIsLeftOutAndReported) {
    osm.way(sizedRectangle(0, 0, 10, 10), {{"building", "yes"}, {"height", "9"}});
    const auto station =
        osm.way(sizedRectangle(20, 0, 10, 10), {{"building", "train_station"}, {"location", "underground"}});
    const auto cellar = osm.way(sizedRectangle(40, 0, 10, 10), {{"building", "yes"}, {"layer", "-2"}});
    only();
    EXPECT_THAT(placesOf("underground"), ElementsAre(station, cellar));
}

TEST_F(OsmSemantics, ACanopyHangsAsAThinSlab) {
    const auto canopy =
        osm.way(sizedRectangle(0, 0, 10, 10), {{"building", "roof"}, {"height", "5"}, {"layer", "1"}});
    const auto bare = osm.way(sizedRectangle(20, 0, 10, 10), {{"building", "roof"}});
    const auto stated =
        osm.way(sizedRectangle(40, 0, 10, 10), {{"building", "roof"}, {"height", "4"}, {"min_height", "3"}});
    piece = read();
    ASSERT_EQ(piece.buildings.size(), 3U);
    for (const auto& building : piece.buildings) EXPECT_TRUE(building->parts[0].isOverhanging);
    EXPECT_FLOAT_EQ(piece.buildings[0]->parts[0].bottomM, 4.5F);
    EXPECT_FLOAT_EQ(piece.buildings[1]->parts[0].topM, 3.2F);
    EXPECT_FLOAT_EQ(piece.buildings[2]->parts[0].bottomM, 3);
    EXPECT_THAT(placesOf("slab"), ElementsAre(canopy, bare));
}

TEST_F(OsmSemantics, NoMeansNo) {
    const auto yes = osm.way(sizedRectangle(0, 0, 10, 10),
                             {{"building", "yes"}, {"building:part", "no"}, {"height", "9"}});
    const auto no = osm.way(sizedRectangle(20, 0, 10, 10), {{"building", "no"}});
    const auto noPart = osm.way(sizedRectangle(40, 0, 10, 10), {{"building:part", "no"}});
    EXPECT_THAT(idsOf(only()), ElementsAre(yes));
    EXPECT_THAT(placesOf("not tagged as a building"), ElementsAre(no, noPart));
}

TEST_F(OsmSemantics, ShapedRoofsAreFlatAndCounted) {
    const auto gabled = osm.way(sizedRectangle(0, 0, 10, 10),
                                {{"building", "yes"}, {"height", "9"}, {"roof:shape", "gabled"}});
    osm.way(sizedRectangle(20, 0, 10, 10), {{"building", "yes"}, {"height", "9"}, {"roof:shape", "flat"}});
    piece = read();
    EXPECT_FLOAT_EQ(piece.buildings[0]->parts[0].topM, 9);
    EXPECT_THAT(placesOf("roof is not flat"), ElementsAre(gabled));
}

TEST_F(OsmSemantics, AnyTagMayBeTheUsersHeight) {
    osm.way(sizedRectangle(0, 0, 10, 10), {{"building", "yes"}, {"height", "9"}, {"est:eaves", "70"}});
    settings.heightField = "est:eaves";
    settings.heightUnit = LengthUnit::feet;
    EXPECT_NEAR(only().parts[0].topM, 21.336, 1e-4);
}

TEST_F(OsmSemantics, ABuildingInTheMakingSaysSo) {
    osm.way(sizedRectangle(0, 0, 10, 10), {{"building", "construction"}, {"height", "9"}});
    EXPECT_EQ(only().status, "under construction");
}

}  // namespace

}  // namespace noonmark
