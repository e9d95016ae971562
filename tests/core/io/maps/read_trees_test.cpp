#include "core/io/trees/read_trees.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/base/gdal_calls.h"
#include "core/io/heights/tree_fields.h"
#include "core/io/read_city.h"
#include "core/io/write_raster.h"
#include "core/measures/shadow_figures.h"
#include "core/study/study.h"
#include "tests/core/io/cityjson_fixtures.h"
#include "tests/core/io/footprint_files.h"
#include "tests/core/io/terrain_files.h"

namespace noonmark {
namespace {

using namespace tests;
using testing::Contains;
using testing::HasSubstr;

/// Headings and one row of an inventory.
struct Inventory {
    std::vector<std::string> fields, values;
};

TreeFacts factsOf(const Inventory& inventory) {
    Warnings warnings;
    TreeFacts facts =
        collectTreeFacts(findTreeFields(inventory.fields), inventory.values, "a tree", warnings);
    EXPECT_TRUE(warnings.empty()) << inventory.fields.front();
    return facts;
}

TEST(TreeFields, OfNewYorkAndSanFranciscoAreInInches) {
    const TreeFacts newYork =
        factsOf({{"tree_id", "tree_dbh", "spc_latin"}, {"1", "10", "Quercus palustris"}});
    EXPECT_NEAR(*newYork.stemDiameterM, 0.254, 1e-9);
    EXPECT_EQ(newYork.species, "Quercus palustris");
    const TreeFacts sanFrancisco =
        factsOf({{"TreeID", "qSpecies", "DBH"}, {"1", "Platanus x hispanica :: Sycamore", "20"}});
    EXPECT_NEAR(*sanFrancisco.stemDiameterM, 0.508, 1e-9);
    EXPECT_EQ(sanFrancisco.species, "Platanus x hispanica");
}

TEST(TreeFields, OfParisHaveAGirthAndAnEpithet) {
    const TreeFacts paris = factsOf(
        {{"circonferenceencm", "genre", "espece", "hauteurenm"}, {"100", "Platanus", "x hispanica", "12"}});
    EXPECT_NEAR(*paris.stemDiameterM, 1 / std::numbers::pi, 1e-9);
    EXPECT_EQ(*paris.heightM, 12);
    EXPECT_EQ(paris.species, "Platanus x hispanica");
}

TEST(TreeFields, OfBerlinAreMetresAndOfViennaClasses) {
    const TreeFacts berlin =
        factsOf({{"BaumHoehe", "KroneDurch", "StammUmfg", "Art_Bot"}, {"8", "6", "157", "Tilia cordata"}});
    EXPECT_EQ(*berlin.heightM, 8);
    EXPECT_EQ(*berlin.crownDiameterM, 6);
    EXPECT_NEAR(*berlin.stemDiameterM, 0.4997, 1e-3);
    const TreeFacts vienna =
        factsOf({{"BAUMHOEHE", "KRONENDURCHMESSER", "STAMMUMFANG", "GATTUNG_ART"}, {"2", "3", "60", "Acer"}});
    EXPECT_EQ(*vienna.heightM, 8);
    EXPECT_EQ(*vienna.crownDiameterM, 8);
}

TEST(TreeFields, OfMelbourneTorontoMontrealSeattleAndZurichAreKnown) {
    EXPECT_NEAR(
        *factsOf({{"Genus", "Scientific Name", "Diameter Breast Height"}, {"Ulmus", "Ulmus procera", "50"}})
             .stemDiameterM,
        0.5, 1e-9);
    EXPECT_NEAR(*factsOf({{"BOTANICAL_NAME", "DBH_TRUNK"}, {"Acer", "30"}}).stemDiameterM, 0.3, 1e-9);
    EXPECT_NEAR(*factsOf({{"Essence_latin", "DHP"}, {"Acer", "30"}}).stemDiameterM, 0.3, 1e-9);
    const TreeFacts seattle = factsOf({{"SCIENTIFIC", "DIAM", "TREEHEIGHT"}, {"Acer rubrum", "10", "40"}});
    EXPECT_NEAR(*seattle.heightM, 12.192, 1e-9);
    EXPECT_NEAR(*seattle.stemDiameterM, 0.254, 1e-9);
    const TreeFacts zurich = factsOf({{"baumgattunglat", "baumartlat", "kronendurchmesser", "baumtyptext"},
                                      {"Pinus", "nigra", "7", "Nadelbaum"}});
    EXPECT_EQ(*zurich.crownDiameterM, 7);
    EXPECT_EQ(zurich.species, "Pinus nigra");
    EXPECT_TRUE(*zurich.needles);
}

TEST(TreeFields, LengthsMayBeClassesAndHaveUnits) {
    EXPECT_EQ(parseTreeLength("6-10 m", LengthUnit::metres), 8);
    EXPECT_EQ(parseTreeLength("6 - 10", LengthUnit::metres), 8);
    EXPECT_EQ(parseTreeLength("> 35 m", LengthUnit::metres), 35);
    EXPECT_NEAR(*parseTreeLength("40", LengthUnit::feet), 12.192, 1e-9);
    EXPECT_FALSE(parseTreeLength("tall", LengthUnit::metres));
    EXPECT_FALSE(parseTreeLength("10-6", LengthUnit::metres));
    EXPECT_FALSE(parseTreeLength("", LengthUnit::metres));
}

TEST(TreeFields, WhatNoTreeHasIsLeftOutWithAWarning) {
    Warnings warnings;
    const std::vector<std::string> names{"height", "tree_dbh"}, values{"900", "big"};
    const TreeFacts facts = collectTreeFacts(findTreeFields(names), values, "tree 7", warnings);
    EXPECT_FALSE(facts.heightM);
    EXPECT_FALSE(facts.stemDiameterM);
    ASSERT_EQ(warnings.size(), 2);
    EXPECT_THAT(warnings[0].where, HasSubstr("tree 7: height 900"));
}

class ReadTreesTest : public testing::Test {
protected:
    Result<TreesRead> tryRead(const std::filesystem::path& file) {
        NoProgress quiet;
        return readTrees(file, {}, quiet, {});
    }
    TemporaryFolder folder_;
};

TEST_F(ReadTreesTest, ATableWithPlacesInInches) {
    const auto read = tryRead(folder_.file("trees.csv",
                                           "tree_id,tree_dbh,spc_latin,latitude,longitude\n"
                                           "1,10,Platanus x acerifolia,40.7501,-73.9801\n"
                                           "2,0,Tilia cordata,40.7502,-73.9802\n"
                                           "3,12,,,\n"));
    ASSERT_TRUE(read) << read.error().text();
    ASSERT_EQ(read->trees.size(), 2);
    EXPECT_NEAR(*read->trees[0].facts.stemDiameterM, 0.254, 1e-9);
    EXPECT_NEAR(read->trees[0].place.lonDeg, -73.9801, 1e-9);
    EXPECT_FALSE(read->trees[1].facts.stemDiameterM);
    EXPECT_THAT(whats(read->warnings), Contains("a tree without a place"));
}

TEST_F(ReadTreesTest, PointsOfAMap) {
    const auto read = tryRead(folder_.file(
        "trees.geojson",
        R"({"type":"FeatureCollection","features":[{"type":"Feature","properties":{"height":"12 m","genus":"Acer"},)"
        R"("geometry":{"type":"Point","coordinates":[-73.98,40.75]}}]})"));
    ASSERT_TRUE(read) << read.error().text();
    ASSERT_EQ(read->trees.size(), 1);
    EXPECT_EQ(read->trees[0].facts.heightM, 12);
    EXPECT_EQ(read->trees[0].facts.species, "Acer");
}

TEST_F(ReadTreesTest, LeafDaysOfATreeAreRead) {
    const auto read =
        tryRead(folder_.file("t.csv",
                             "height,leaf_on_day,leaf_off_day,lat,lon\n9,05-02,2025-10-31,40.75,-73.98\n"
                             "9,122,,40.76,-73.98\n9,soon,400,40.77,-73.98\n"));
    ASSERT_TRUE(read) << read.error().text();
    ASSERT_EQ(read->trees.size(), 3U);
    EXPECT_EQ(read->trees[0].facts.leafOnDay, 122);
    EXPECT_EQ(completeTree(read->trees[0].facts).leafOffDay, 304);
    EXPECT_EQ(read->trees[1].facts.leafOnDay, 122);
    EXPECT_EQ(read->trees[1].facts.leafOffDay, std::nullopt);
    EXPECT_EQ(read->trees[2].facts.leafOnDay, std::nullopt);
    EXPECT_THAT(whats(read->warnings), Contains(HasSubstr("no day of the year")));
}

// GDAL takes such values of GeoJSON for dates, and writes them with slashes.
TEST_F(ReadTreesTest, LeafDaysOfAColumnOfDatesAreRead) {
    const auto read = tryRead(folder_.file("t.geojson", R"({"type": "FeatureCollection", "features": [
{"type": "Feature", "geometry": {"type": "Point", "coordinates": [-73.98, 40.75]},
 "properties": {"height": 9, "leaf_on_day": "2026-04-15", "leaf_off_day": "2024-10-31"}},
{"type": "Feature", "geometry": {"type": "Point", "coordinates": [-73.98, 40.76]},
 "properties": {"height": 9, "leaf_on_day": "2024-02-29", "leaf_off_day": "2024-12-31"}}]})"));
    ASSERT_TRUE(read) << read.error().text();
    ASSERT_EQ(read->trees.size(), 2U);
    EXPECT_EQ(read->trees[0].facts.leafOnDay, 105);
    EXPECT_EQ(read->trees[0].facts.leafOffDay, 304) << "in leap years, too";
    EXPECT_EQ(read->trees[1].facts.leafOnDay, 60) << "as 1 March";
    EXPECT_EQ(read->trees[1].facts.leafOffDay, 365);
}

TEST(TreeFields, ALeafDayIsAWholeNumber) {
    const auto dayOf = [](const char* written, std::size_t warningCount) {
        const std::vector<std::string> fields{"leaf_on_day", "height"}, values{written, "9"};
        Warnings warnings;
        const TreeFacts facts = collectTreeFacts(findTreeFields(fields), values, "a tree", warnings);
        EXPECT_EQ(warnings.size(), warningCount) << written;
        return facts.leafOnDay;
    };
    EXPECT_EQ(dayOf("3.7", 1), std::nullopt);
    EXPECT_EQ(dayOf("105.0", 0), 105);
    EXPECT_EQ(dayOf("2026/04/15 00:00:00", 0), 105);
    EXPECT_EQ(dayOf("2026-02-30", 1), std::nullopt);
}

TEST_F(ReadTreesTest, AStemOfNoStatedUnitIsReported) {
    const auto read = tryRead(folder_.file("t.csv", "dbh,lat,lon\n30,40.75,-73.98\n"));
    ASSERT_TRUE(read);
    EXPECT_NEAR(*read->trees[0].facts.stemDiameterM, 0.3, 1e-9);
    EXPECT_THAT(whats(read->warnings), Contains(HasSubstr("taken as centimetres")));
}

TEST_F(ReadTreesTest, ARasterOfCanopyIsAColumnForEachCell) {
    const auto file = writeTerrain(folder_.path("canopy.tif"), manhattan,
                                   [](double x, double y) { return std::hypot(x, y) < 5 ? 12 : 1; });
    const auto read = tryRead(file);
    ASSERT_TRUE(read) << read.error().text();
    double areaM2 = 0;
    for (const ReadTree& tree : read->trees) {
        const Tree column = completeTree(tree.facts);
        EXPECT_EQ(column.heightM, 12);
        EXPECT_EQ(column.shape, CrownShape::cylinder);
        areaM2 += std::numbers::pi / 4 * column.crownDiameterM * column.crownDiameterM;
    }
    EXPECT_NEAR(areaM2, 25 * std::numbers::pi, 3);
    EXPECT_FALSE(tryRead(writeTerrain(folder_.path("low.tif"), manhattan, [](double, double) { return 1; })));
}

TEST_F(ReadTreesTest, FilesWithoutTreesAreRefused) {
    const auto table = tryRead(folder_.file("t.csv", "a,b\n1,2\n"));
    ASSERT_FALSE(table);
    EXPECT_THAT(table.error().text(), HasSubstr("It holds no trees"));
    EXPECT_FALSE(tryRead(folder_.file("t.osm", "<osm version=\"0.6\"></osm>")));
    EXPECT_FALSE(tryRead("nowhere.csv"));
}

TEST_F(ReadTreesTest, OfCityJsonHaveTheMeasuresThatTheyOrTheirShapesState) {
    CityJsonMaker maker;
    maker.addBuilding("cube", maker.boxSolid({0, 0, 0}, {10, 20, 30}));
    maker.addBuilding("round", maker.boxSolid({30, 0, 0}, {36, 6, 14}));
    maker.addBuilding("stated", maker.boxSolid({50, 0, 0}, {56, 6, 14}));
    Json document = maker.document("2.0", "EPSG:28992");
    for (const char* id : {"round", "stated"})
        document["CityObjects"][id]["type"] = "SolitaryVegetationObject";
    document["CityObjects"]["stated"]["attributes"] = {
        {"height", 20}, {"trunkDiameter", 0.4}, {"species", "Acer"}};
    const auto piece = noonmark::tests::read(document);
    ASSERT_TRUE(piece) << piece.error().text();
    EXPECT_EQ(piece->buildings.size(), 1);
    ASSERT_EQ(piece->trees.size(), 2);
    EXPECT_NEAR(*piece->trees[0].facts.heightM, 14, 1e-3);
    EXPECT_NEAR(*piece->trees[0].facts.crownDiameterM, 6, 0.1);
    EXPECT_EQ(*piece->trees[1].facts.heightM, 20);
    EXPECT_NEAR(*piece->trees[1].facts.stemDiameterM, 0.4, 1e-9);
    const glm::dvec2 place = piece->frame->localFromLonLat(piece->trees[1].place) -
                             piece->frame->localFromLonLat(piece->trees[0].place);
    EXPECT_NEAR(place.x, 20, 0.1);
}

constexpr const char* osmTown = R"(<osm version="0.6">
<node id="1" lat="40.0000" lon="0.0000"/><node id="2" lat="40.0000" lon="0.0002"/>
<node id="3" lat="40.0002" lon="0.0002"/><node id="4" lat="40.0002" lon="0.0000"/>
<node id="5" lat="40.0004" lon="0.0001"><tag k="natural" v="tree"/><tag k="height" v="15"/>
<tag k="diameter_crown" v="8"/><tag k="leaf_cycle" v="evergreen"/></node>
<node id="6" lat="40.0005" lon="0.0001"><tag k="natural" v="tree"/><tag k="circumference" v="1.57"/></node>
<node id="7" lat="40.0006" lon="0.0000"/><node id="8" lat="40.0006" lon="0.0005"/>
<way id="1"><nd ref="1"/><nd ref="2"/><nd ref="3"/><nd ref="4"/><nd ref="1"/><tag k="building" v="yes"/></way>
<way id="2"><nd ref="7"/><nd ref="8"/><tag k="natural" v="tree_row"/><tag k="genus" v="Tilia"/></way>
</osm>)";

TEST_F(ReadTreesTest, OfOpenStreetMapComeWithTheCity) {
    NoProgress quiet;
    const auto read = readCity({folder_.file("town.osm", osmTown)}, {}, quiet, {});
    ASSERT_TRUE(read) << read.error().text();
    ASSERT_TRUE(read->city.trees);
    const auto& trees = read->city.trees->trees;
    ASSERT_EQ(trees.size(), 8);  // two, and six along 42.6 m
    EXPECT_EQ(trees[0].sourceId, "node 5");
    EXPECT_EQ(trees[0].heightM, 15);
    EXPECT_EQ(trees[0].crownDiameterM, 8);
    EXPECT_TRUE(trees[0].evergreen);
    EXPECT_EQ(trees[1].crownSource, TreeSource::estimated);
    EXPECT_EQ(trees[2].species, "Tilia");
    EXPECT_THAT(whats(read->warnings), Contains("the trees of a row stand 8 m apart"));
}

// A square of 0.0004 x 0.0004 degrees at the equator, 44.5 x 44.2 m, beside the building: 30 squares of 8 m
// have their middle in it, or one row or column more.
TEST_F(ReadTreesTest, ASecondBandOfCanopyIsTheBaseOfItsCrowns) {
    const Grid grid{0, 0, 1, 3, 1};
    const std::vector<float> tops{10, 10, 10}, bases{6, 12, std::nanf("")};
    const auto file = folder_.path("canopy.tif");
    ASSERT_TRUE(
        writeGeoTiff(file, Frame({-73.98, 40.75}), grid, {{"top", "m", &tops}, {"base", "m", &bases}}));
    NoProgress quiet;
    const auto read = readTrees(file, {}, quiet, {});
    ASSERT_TRUE(read) << read.error().text();
    ASSERT_EQ(read->trees.size(), 3U);
    const auto baseOf = [&](std::size_t i) { return completeTree(read->trees[i].facts).crownBaseM; };
    EXPECT_FLOAT_EQ(baseOf(0), 6);
    EXPECT_FLOAT_EQ(baseOf(1), 2.5F) << "above the top";
    EXPECT_FLOAT_EQ(baseOf(2), 2.5F) << "not known";
}

TEST_F(ReadTreesTest, AWoodOfOpenStreetMapIsClosedCanopy) {
    const auto town = [](std::string_view tags) {
        return fmt::format(R"(<osm version="0.6">
<node id="1" lat="0.0000" lon="0.0000"/><node id="2" lat="0.0000" lon="0.0002"/>
<node id="3" lat="0.0002" lon="0.0002"/><node id="4" lat="0.0002" lon="0.0000"/>
<node id="5" lat="0.0010" lon="0.0000"/><node id="6" lat="0.0010" lon="0.0004"/>
<node id="7" lat="0.0014" lon="0.0004"/><node id="8" lat="0.0014" lon="0.0000"/>
<way id="1"><nd ref="1"/><nd ref="2"/><nd ref="3"/><nd ref="4"/><nd ref="1"/><tag k="building" v="yes"/></way>
<way id="2"><nd ref="5"/><nd ref="6"/><nd ref="7"/><nd ref="8"/><nd ref="5"/>{}</way></osm>)",
                           tags);
    };
    NoProgress quiet;
    const auto read = [&](std::string_view tags) {
        return readCity({folder_.file("town.osm", town(tags))}, {}, quiet, {}).value();
    };
    const CityRead wood = read(R"(<tag k="natural" v="wood"/><tag k="height" v="18"/>)");
    ASSERT_TRUE(wood.city.trees);
    const auto& columns = wood.city.trees->trees;
    EXPECT_NEAR(double(columns.size()) * 64, 44.5 * 44.2, 8 * 45);
    for (const Tree& column : columns) {
        EXPECT_EQ(column.shape, CrownShape::cylinder);
        EXPECT_EQ(column.heightM, 18);
        EXPECT_EQ(column.heightSource, TreeSource::measured);
        EXPECT_EQ(column.crownSource, TreeSource::assumed) << "an outline measures no crown";
        EXPECT_NEAR(column.crownDiameterM, std::sqrt(64 * 4 / std::numbers::pi), 1e-4);
        EXPECT_FALSE(column.evergreen);
    }
    EXPECT_THAT(whats(wood.warnings), Contains("a wood is taken as closed canopy, in columns of 8 x 8 m"));
    const CityRead firs = read(R"(<tag k="natural" v="wood"/><tag k="leaf_type" v="needleleaved"/>)");
    EXPECT_TRUE(firs.city.trees->trees[0].evergreen);
    EXPECT_EQ(firs.city.trees->trees[0].heightSource, TreeSource::assumed);
    const CityRead water = read(R"(<tag k="natural" v="water"/>)");
    EXPECT_FALSE(water.city.trees);
    EXPECT_EQ(water.features, wood.features) << "no polygon that might be a building";
}

TEST_F(ReadTreesTest, AnAreaOfPlantsOfCityJsonIsClosedCanopy) {
    CityJsonMaker maker;
    maker.addBuilding("house", maker.boxSolid({0, 0, 0}, {10, 20, 30}));
    maker.addBuilding("grove", maker.boxSolid({40, 0, 0}, {80, 24, 9}));
    maker.addBuilding("lawn", maker.boxSolid({40, 40, 0}, {80, 64, 0.5}));
    Json document = maker.document("2.0", "EPSG:28992");
    for (const char* id : {"grove", "lawn"}) document["CityObjects"][id]["type"] = "PlantCover";
    const auto piece = noonmark::tests::read(document);
    ASSERT_TRUE(piece) << piece.error().text();
    EXPECT_EQ(piece->buildings.size(), 1);
    EXPECT_NEAR(double(piece->trees.size()) * 64, 40 * 24, 8 * 40) << "the bottom counts once";
    for (const ReadTree& tree : piece->trees) EXPECT_NEAR(*tree.facts.heightM, 9, 1e-3);
    EXPECT_THAT(whats(piece->warnings), Contains("plants lower than 2 m"));
}

// Two cells a quarter of a metre apart, and a tree below them.
TEST(JoinTrees, CanopyThatIsReadAgainStaysOnceAndTreesStandBesideIt) {
    City city;
    city.frame = Frame({13.4, 52.5}, 0);
    const auto readAt = [&](double eastM, std::optional<double> cellM2) {
        return ReadTree{city.frame.lonLatFromLocal({eastM, 0}), {.heightM = 9, .canopyCellM2 = cellM2}};
    };
    const std::vector<ReadTree> canopy{readAt(0, 0.0625), readAt(0.25, 0.0625)};
    Warnings warnings;
    city.trees = joinTrees(canopy, city, 1000, warnings);
    ASSERT_EQ(city.trees->trees.size(), 2U);
    city.trees = joinTrees({readAt(0, std::nullopt)}, city, 1000, warnings);
    EXPECT_EQ(city.trees->trees.size(), 3U);
    EXPECT_TRUE(warnings.empty());
    city.trees = joinTrees(canopy, city, 1000, warnings);
    EXPECT_EQ(city.trees->trees.size(), 3U);
    EXPECT_EQ(warnings.size(), 2U);
}

// The town's buildings end at 0.002 deg east; a tree 200 m beyond them stands and is part of their city.
TEST_F(ReadTreesTest, TreesBeyondTheBuildingsAreUsed) {
    NoProgress quiet;
    const auto alone = readCity({folder_.file("town.osm", osmTown)}, {}, quiet, {});
    ASSERT_TRUE(alone) << alone.error().text();
    const Box2 box = bounds(alone->city);
    const LonLat at = alone->city.frame.lonLatFromLocal(glm::dvec2(box.high) + 200.0);
    const auto beyond =
        folder_.file("beyond.csv", fmt::format("height,lat,lon\n30,{:.7f},{:.7f}\n", at.latDeg, at.lonDeg));
    const auto read =
        readCity({folder_.file("town.osm", osmTown)}, {.treeFiles = {beyond.string()}}, quiet, {});
    ASSERT_TRUE(read) << read.error().text();
    EXPECT_EQ(read->city.trees->trees.size(), alone->city.trees->trees.size() + 1);
    const Tree& tree = read->city.trees->trees.back();
    EXPECT_NEAR(tree.place.x, double(box.high.x) + 200, 0.1);
    // Its crown stands before the sun of a receiver beyond the buildings, too.
    StudySettings settings;
    settings.region = makeRegionFromLocalBox(
        {glm::vec2(tree.place) + glm::vec2(-20, 0), glm::vec2(tree.place) + glm::vec2(20, 40)});
    settings.receivers.cellM = 4;
    settings.period.days = 1;
    settings.period.stepMinutes = 30;
    settings.errorSample.receivers = 0;
    const auto study = runStudy(read->city, settings, quiet, {});
    ASSERT_TRUE(study) << study.error().text();
    ASSERT_TRUE(study->field.trees) << "it reaches them";
    EXPECT_EQ(study->field.trees->treesUsed, 1U);
    EXPECT_GT(computeStatistics(*study->field.trees->evergreen).meanGrossMin,
              study->statistics.meanGrossMin + 1);
}

TEST_F(ReadTreesTest, AnInventoryJoinsTheTreesOfTheCity) {
    const auto inventory =
        folder_.file("more.csv", "height,lat,lon\n9,40.0003,0.0005\n9,40.0004,0.0001\n9,50,10\n");
    NoProgress quiet;
    const auto read =
        readCity({folder_.file("town.osm", osmTown)}, {.treeFiles = {inventory.string()}}, quiet, {});
    ASSERT_TRUE(read) << read.error().text();
    EXPECT_EQ(read->city.trees->trees.size(), 9);
    EXPECT_THAT(whats(read->warnings), Contains("a second tree at the same place"));
    EXPECT_THAT(whats(read->warnings), Contains("a tree far from the buildings"));
    EXPECT_FALSE(readCity({folder_.file("town.osm", osmTown)}, {.treeFiles = {"none.csv"}}, quiet, {}));
}

}  // namespace
}  // namespace noonmark
