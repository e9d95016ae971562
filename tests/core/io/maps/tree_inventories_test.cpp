// Trees of our own in the forms in which cities publish theirs: the same columns, delimiters, units, systems
// and words, with what becomes of them worked out by the published ratios (resources/trees/defaults.json).

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>

#include "core/io/trees/list_trees.h"
#include "core/io/trees/read_trees.h"
#include "tests/core/io/footprint_files.h"

namespace noonmark {
namespace {

using namespace tests;
using testing::Contains;
using testing::HasSubstr;

constexpr double inchM = 0.0254, footM = 0.3048;
constexpr double crownPerStem = 25.5, heightPerCrown = 1.4;  // of broadleaved trees
constexpr double coniferCrownPerStem = 18, coniferHeightPerCrown = 2.2;

class TreeInventories : public testing::Test {
protected:
    void read(const std::string& name, const std::string& text, const TreeReading& how = {}) {
        NoProgress quiet;
        auto made = readTrees(folder_.file(name, text), how, quiet, {});
        ASSERT_TRUE(made) << made.error().text();
        read_ = *std::move(made);
        trees_.clear();
        for (const ReadTree& one : read_.trees) trees_.push_back(completeTree(one.facts));
    }
    // Warnings of one text.
    std::size_t count(std::string_view what) const {
        return std::size_t(std::ranges::count(read_.warnings, what, &Warning::what));
    }
    void expectPlace(std::size_t tree, double lonDeg, double latDeg, double toleranceDeg = 1e-9) const {
        EXPECT_NEAR(read_.trees[tree].place.lonDeg, lonDeg, toleranceDeg);
        EXPECT_NEAR(read_.trees[tree].place.latDeg, latDeg, toleranceDeg);
    }
    void expectSize(std::size_t tree, double heightM, double crownM) const {
        EXPECT_NEAR(trees_[tree].heightM, heightM, 1e-4) << "tree " << tree;
        EXPECT_NEAR(trees_[tree].crownDiameterM, crownM, 1e-4) << "tree " << tree;
    }
    static constexpr const char* noTree = "a stump, an empty pit or a tree that is dead, felled or planned";
    static constexpr const char* zero = "a measure of a tree is 0 and counts as not stated";
    static constexpr const char* tooMuch = "a measure of a tree that no tree has";
    static constexpr const char* noNumber = "a measure of a tree that is no number";
    TemporaryFolder folder_;
    TreesRead read_;
    std::vector<Tree> trees_;
};

TEST_F(TreeInventories, NewYorkCountsStemsInInchesAndListsStumps) {
    read("street_trees.csv",
         "tree_id,block_id,created_at,the_geom,tree_dbh,stump_diam,curb_loc,status,health,spc_latin,spc_"
         "common,borough,latitude,longitude,x_sp,y_sp\n"
         "1,100,08/27/2025,POINT (-73.98 40.75),10,0,OnCurb,Alive,Fair,Platanus x "
         "acerifolia,planetree,Manhattan,40.75,-73.98,988000.1,212000.2\n"
         "2,100,08/27/2025,POINT (-73.981 40.751),0,12,OnCurb,Stump,,,,Manhattan,40.751,-73.981,988001,"
         "212001\n"
         "3,101,08/27/2025,POINT (-73.982 40.752),4,0,OnCurb,Dead,,,,Manhattan,40.752,-73.982,988002,"
         "212002\n"
         "4,101,08/27/2025,POINT (-73.983 40.753),425,0,OnCurb,Alive,Good,Ginkgo "
         "biloba,ginkgo,Manhattan,40.753,-73.983,988003,212003\n");
    ASSERT_EQ(trees_.size(), 2U);
    const double crownM = 10 * inchM * crownPerStem;
    expectSize(0, crownM * heightPerCrown, crownM);
    expectPlace(0, -73.98, 40.75);
    EXPECT_EQ(trees_[0].crownSource, TreeSource::estimated);
    EXPECT_EQ(trees_[1].crownSource, TreeSource::assumed) << "a stem of 10.8 m is an error";
    EXPECT_EQ(count(noTree), 2U);
    EXPECT_EQ(count(tooMuch), 1U);
}

TEST_F(TreeInventories, SanFranciscoNamesLatinBeforeCommonAndSitesWithoutTrees) {
    read("Street_Tree_List.csv",
         "TreeID,qLegalStatus,qSpecies,qAddress,SiteOrder,qSiteInfo,PlantType,DBH,PlotSize,XCoord,YCoord,"
         "Latitude,Longitude,Location\n"
         "1,Permitted,Platanus x hispanica :: Sycamore: London Plane,1 A St,1,Sidewalk,Tree,20,3x3,6000000,"
         "2100000,37.77,-122.42,\"(37.77, -122.42)\"\n"
         "2,DPW Maintained,Tree(s) ::,2 A St,1,Sidewalk,Tree,,,,,37.771,-122.421,\"(37.771, -122.421)\"\n"
         "3,DPW Maintained,Potential Site :: Potential Site,3 A "
         "St,1,Sidewalk,Tree,,,,,37.772,-122.422,\"(37.772, -122.422)\"\n"
         "4,DPW Maintained,Pinus radiata :: Monterey Pine,4 A St,1,Sidewalk,Tree,9999,,,,37.773,-122.423,\n"
         "5,DPW Maintained,Shrub :: Shrub,5 A St,1,Sidewalk,Landscaping,2,,,,37.774,-122.424,\n"
         "6,DPW Maintained,Pinus radiata :: Monterey Pine,6 A St,1,Sidewalk,Tree,10,,,,,,\n"
         "7,DPW Maintained,Pinus radiata :: Monterey Pine,7 A St,1,Sidewalk,Tree,10,,,,37.775,-122.425,\n");
    ASSERT_EQ(trees_.size(), 4U);
    const double crownM = 20 * inchM * crownPerStem;
    expectSize(0, crownM * heightPerCrown, crownM);
    EXPECT_EQ(trees_[0].species, "Platanus x hispanica");
    EXPECT_EQ(trees_[1].species, "") << "\"Tree(s)\" is no species";
    const double coniferM = 10 * inchM * coniferCrownPerStem;
    expectSize(3, coniferM * coniferHeightPerCrown, coniferM);
    EXPECT_EQ(trees_[3].shape, CrownShape::cone);
    EXPECT_EQ(count(noTree), 2U);
    EXPECT_EQ(count(tooMuch), 1U);
    EXPECT_EQ(count("a tree without a place"), 1U);
    EXPECT_EQ(count("the species of trees is not known"), 1U);
}

// Heads of the table, and keys of its GeoJSON.
TEST_F(TreeInventories, ParisHasGirthsInCentimetresInATableWithSemicolons) {
    read("les-arbres.csv",
         "\xEF\xBB\xBFIDBASE;TYPE EMPLACEMENT;DOMANIALITE;LIBELLE FRANCAIS;GENRE;ESPECE;VARIETE OU "
         "CULTIVAR;CIRCONFERENCE (cm);HAUTEUR (m);STADE DE DEVELOPPEMENT;REMARQUABLE;geo_point_2d\n"
         "1;Arbre;Alignement;Platane;Platanus;x hispanica;;157;18;Adulte;NON;48.857, 2.347\n"
         "2;Arbre;Alignement;Tilleul;Tilia;tomentosa;;0;0;;NON;48.858, 2.348\n"
         "3;Arbre;Jardin;Pin;Pinus;nigra;;100;881818;Adulte;NON;48.859, 2.349\n");
    ASSERT_EQ(trees_.size(), 3U);
    const auto crownOf = [](double girthM, double perStem) { return girthM / std::numbers::pi * perStem; };
    expectSize(0, 18, crownOf(1.57, crownPerStem));
    EXPECT_EQ(trees_[0].heightSource, TreeSource::measured);
    EXPECT_EQ(trees_[0].species, "Platanus x hispanica");
    expectPlace(0, 2.347, 48.857);
    EXPECT_EQ(trees_[1].heightSource, TreeSource::assumed);
    EXPECT_EQ(count(zero), 2U);
    const double pineM = crownOf(1, coniferCrownPerStem);
    expectSize(2, pineM * coniferHeightPerCrown, pineM);
    EXPECT_EQ(count(tooMuch), 1U);

    read(
        "les-arbres.geojson",
        R"({"type":"FeatureCollection","features":[{"type":"Feature","geometry":{"type":"Point","coordinates":[2.3,48.8]},
"properties":{"idbase":1,"typeemplacement":"Arbre","libellefrancais":"Marronnier","genre":"Aesculus","espece":"hippocastanum",
"circonferenceencm":314,"hauteurenm":20,"geo_point_2d":{"lon":2.3,"lat":48.8}}}]})");
    ASSERT_EQ(trees_.size(), 1U);
    expectSize(0, 20, crownOf(3.14, crownPerStem));
    expectPlace(0, 2.3, 48.8);
}

TEST_F(TreeInventories, BerlinStatesHeightAndCrownInMetresOfItsOwnSystem) {
    read(
        "baumbestand.geojson",
        R"({"type":"FeatureCollection","crs":{"type":"name","properties":{"name":"urn:ogc:def:crs:EPSG::25833"}},
"features":[{"type":"Feature","geometry":{"type":"Point","coordinates":[391000.0,5820000.0]},"properties":{"gisid":"1",
"standortnr":"25","art_dtsch":"Winter-Linde","art_bot":"Tilia cordata","gattung_deutsch":"LINDE","gattung":"TILIA",
"pflanzjahr":"1970","standalter":56.0,"kronedurch":8.0,"stammumfg":157,"baumhoehe":14.0}},
{"type":"Feature","geometry":{"type":"Point","coordinates":[391010.0,5820000.0]},"properties":{"gisid":"2",
"art_bot":null,"gattung":null,"kronedurch":null,"stammumfg":100,"baumhoehe":null}}]})");
    ASSERT_EQ(trees_.size(), 2U);
    expectSize(0, 14, 8);
    EXPECT_EQ(trees_[0].species, "Tilia cordata");
    EXPECT_EQ(trees_[0].crownSource, TreeSource::measured);
    expectPlace(0, 13.39354, 52.51920, 1e-5);
    const double crownM = 1 / std::numbers::pi * crownPerStem;
    expectSize(1, crownM * heightPerCrown, crownM);
}

// A year of planting is not a size: what is assumed is said, once the tree has no measure at all.
TEST_F(TreeInventories, AYearOfPlantingIsNoSize) {
    read("baumbestand.geojson",
         R"({"type":"FeatureCollection","features":[
{"type":"Feature","geometry":{"type":"Point","coordinates":[13.39,52.52]},
"properties":{"art_bot":"Tilia cordata","pflanzjahr":"1970","kronedurch":null,"stammumfg":157,"baumhoehe":14.0}},
{"type":"Feature","geometry":{"type":"Point","coordinates":[13.391,52.52]},
"properties":{"art_bot":"Tilia cordata","pflanzjahr":"1970","kronedurch":null,"stammumfg":null,"baumhoehe":null}},
{"type":"Feature","geometry":{"type":"Point","coordinates":[13.392,52.52]},
"properties":{"art_bot":"Tilia cordata","pflanzjahr":"2020","kronedurch":null,"stammumfg":null,"baumhoehe":null}}]})");
    ASSERT_EQ(trees_.size(), 3U);
    EXPECT_EQ(trees_[1].heightSource, TreeSource::assumed);
    EXPECT_EQ(trees_[1].heightM, trees_[2].heightM) << "older, not higher";
    EXPECT_EQ(std::ranges::count_if(read_.warnings,
                                    [](const Warning& warning) {
                                        return warning.what.starts_with("a tree has a year of planting");
                                    }),
              2);
}

TEST_F(TreeInventories, ViennaHasClassesAndPlacesAsText) {
    read(
        "BAUMKATOGD.csv",
        "FID,OBJECTID,SHAPE,BAUM_ID,DATENFUEHRUNG,BEZIRK,OBJEKT_STRASSE,GATTUNG_ART,PFLANZJAHR,PFLANZJAHR_"
        "TXT,STAMMUMFANG,STAMMUMFANG_TXT,BAUMHOEHE,BAUMHOEHE_TXT,KRONENDURCHMESSER,KRONENDURCHMESSER_TXT\n"
        "BAUMKATOGD.1,1,POINT (16.37 48.21),1,magistrat,1,Ring,Acer platanoides (Spitzahorn),1990,1990,76,76 "
        "cm,3,11-15 m,2,4-6 m\n"
        "BAUMKATOGD.2,2,POINT (16.371 48.211),2,magistrat,1,Ring,Pinus nigra,0,nicht bekannt,0,nicht "
        "bekannt,0,nicht bekannt,0,nicht bekannt\n"
        "BAUMKATOGD.3,3,POINT (16.372 48.212),3,magistrat,1,Ring,Tilia,1900,1900,300,300 cm,8,> 35 m,8,> 21 "
        "m\n");
    ASSERT_EQ(trees_.size(), 3U);
    expectSize(0, 13, 5);
    expectPlace(0, 16.37, 48.21);
    EXPECT_EQ(trees_[1].heightSource, TreeSource::assumed) << "class 0 is unknown";
    EXPECT_EQ(trees_[1].shape, CrownShape::cone);
    expectSize(2, 37, 23);
    EXPECT_THAT(whats(read_.warnings),
                Contains("the file names no coordinate reference system; its numbers are taken for degrees"));
}

// Its names are Vienna's, its numbers metres.
TEST_F(TreeInventories, HamburgStatesCrownsInMetres) {
    read("strassenbaumkataster.csv",
         "baumid;gattung_latein;art_latein;pflanzjahr;kronendurchmesser;stammumfang;longitude;latitude\n"
         "1;Quercus;Quercus robur;1960;12;188;9.99;53.55\n");
    ASSERT_EQ(trees_.size(), 1U);
    expectSize(0, 12 * heightPerCrown, 12);
    EXPECT_EQ(trees_[0].species, "Quercus robur");
}

TEST_F(TreeInventories, MelbourneCountsCentimetresAtBreastHeight) {
    read("trees-with-species-and-dimensions-urban-forest.csv",
         "CoM ID;Common Name;Scientific Name;Genus;Family;Diameter Breast Height;Year Planted;Age "
         "Description;CoordinateLocation;Latitude;Longitude;Easting;Northing;geolocation\n"
         "1;London Plane;Platanus x acerifolia;Platanus;Platanaceae;40;1990;Mature;\"-37.81, "
         "144.96\";-37.81;144.96;320000;5813000;\"-37.81, 144.96\"\n"
         "2;River red gum;Eucalyptus camaldulensis;Eucalyptus;Myrtaceae;;2010;Juvenile;\"-37.82, "
         "144.97\";-37.82;144.97;320100;5812000;\"-37.82, 144.97\"\n");
    ASSERT_EQ(trees_.size(), 2U);
    expectSize(0, 0.4 * crownPerStem * heightPerCrown, 0.4 * crownPerStem);
    EXPECT_EQ(trees_[0].species, "Platanus x acerifolia");
    expectPlace(0, 144.96, -37.81);
    EXPECT_TRUE(trees_[1].evergreen);
}

TEST_F(TreeInventories, TorontoWritesPlacesAsGeoJsonInATable) {
    read("street-tree-data.csv",
         "_id,OBJECTID,STRUCTID,ADDRESS,STREETNAME,BOTANICAL_NAME,COMMON_NAME,DBH_TRUNK,geometry\n"
         "1,1,NT-1,1,A St,Acer platanoides,\"Maple, Norway\",30,\"{\"\"coordinates\"\": [[-79.38, 43.65]], "
         "\"\"type\"\": \"\"MultiPoint\"\"}\"\n"
         "2,2,NT-2,2,A St,Picea glauca,\"Spruce, white\",20,\"{\"\"coordinates\"\": [[-79.39, 43.66]], "
         "\"\"type\"\": \"\"MultiPoint\"\"}\"\n");
    ASSERT_EQ(trees_.size(), 2U);
    expectSize(0, 0.3 * crownPerStem * heightPerCrown, 0.3 * crownPerStem);
    expectPlace(0, -79.38, 43.65);
    expectSize(1, 0.2 * coniferCrownPerStem * coniferHeightPerCrown, 0.2 * coniferCrownPerStem);
}

TEST_F(TreeInventories, MontrealNamesTheStemInFrench) {
    read("arbres-publics.csv",
         "INV_TYPE,EMP_NO,ARROND,Rue,Emplacement,Coord_X,Coord_Y,SIGLE,Essence_latin,Essence_fr,ESSENCE_ANG,"
         "DHP,Date_releve,Longitude,Latitude\n"
         "R,1,1,rue A,Trottoir,299000,5041000,ACSA,Acer saccharinum,Érable argenté,Silver "
         "Maple,50,2020-01-01,-73.56,45.51\n");
    ASSERT_EQ(trees_.size(), 1U);
    expectSize(0, 0.5 * crownPerStem * heightPerCrown, 0.5 * crownPerStem);
    EXPECT_EQ(trees_[0].species, "Acer saccharinum");
    expectPlace(0, -73.56, 45.51);
}

// A table of ArcGIS Hub: X and Y come first.
TEST_F(TreeInventories, SeattleHasFeetAndInches) {
    const std::string table =
        "X,Y,OBJECTID,UNITID,CURRENT_STATUS,SCIENTIFIC_NAME,COMMON_NAME,DIAM,TREEHEIGHT\n"
        "-122.33,47.61,1,TRE-1,INSVC,Acer rubrum,Red Maple,12,40\n"
        "-122.34,47.62,2,TRE-2,REMOVED,Acer rubrum,Red Maple,12,40\n"
        "-122.35,47.63,3,TRE-3,PLANNED,Planting Pending ...,Planting Pending,,\n";
    read("SDOT_Trees.csv", table);
    ASSERT_EQ(trees_.size(), 1U);
    expectSize(0, 40 * footM, 12 * inchM * crownPerStem);
    expectPlace(0, -122.33, 47.61);
    EXPECT_EQ(count(noTree), 2U);
}

TEST_F(TreeInventories, ATableInMetresOfASystemNeedsItsName) {
    const std::string table = "x,y,dbh_cm,species\n391000,5820000,30,Tilia\n";
    NoProgress quiet;
    const auto refused = readTrees(folder_.file("trees.csv", table), {}, quiet, {});
    ASSERT_FALSE(refused);
    EXPECT_THAT(refused.error().text(), HasSubstr("--crs"));
    read("trees.csv", table, {.crs = "EPSG:25833"});
    expectPlace(0, 13.39354, 52.51920, 1e-5);
}

TEST_F(TreeInventories, PointsOfPostgisNameTheirSystem) {
    read("trees.csv", "dbh_cm,species,geom\n30,Tilia,\"SRID=25833;POINT(391000 5820000)\"\n");
    ASSERT_EQ(trees_.size(), 1U);
    expectPlace(0, 13.39354, 52.51920, 1e-5);
}

TEST_F(TreeInventories, ZurichStatesCrownsAndTypes) {
    read(
        "baumkataster.geojson",
        R"({"type":"FeatureCollection","features":[{"type":"Feature","geometry":{"type":"Point","coordinates":[8.54,47.37]},
"properties":{"poi_id":"1","kategorie":"Strassenbaum","status":"Strassenbaum","baumgattunglat":"Platanus","baumartlat":"x acerifolia",
"baumnamelat":"Platanus x acerifolia","baumtyp":"1","baumtyptext":"Laubbaum","pflanzjahr":1970,"kronendurchmesser":9}},
{"type":"Feature","geometry":{"type":"Point","coordinates":[8.55,47.38]},"properties":{"poi_id":"2","status":"Parkbaum",
"baumgattunglat":null,"baumartlat":null,"baumnamelat":null,"baumtyp":"2","baumtyptext":"Nadelbaum","kronendurchmesser":0}}]})");
    ASSERT_EQ(trees_.size(), 2U);
    expectSize(0, 9 * heightPerCrown, 9);
    EXPECT_EQ(trees_[0].species, "Platanus x acerifolia");
    EXPECT_EQ(trees_[1].shape, CrownShape::cone) << "a conifer without a name";
    EXPECT_EQ(count(zero), 1U);
}

TEST_F(TreeInventories, HeightsMayBeClassesWithDecimalCommasOrDashes) {
    read("trees.csv",
         "species;height;lon;lat\n"
         "Tilia;6-10 m;13.4;52.5\nTilia;6\xE2\x80\x93"
         "10 m;13.41;52.5\nTilia;12,5;13.42;52.5\nTilia;20-30 ft;13.43;52.5\nTilia;tall;13.44;52.5\n");
    ASSERT_EQ(trees_.size(), 5U);
    EXPECT_NEAR(trees_[0].heightM, 8, 1e-6);
    EXPECT_NEAR(trees_[1].heightM, 8, 1e-6);
    EXPECT_NEAR(trees_[2].heightM, 12.5, 1e-6);
    EXPECT_NEAR(trees_[3].heightM, 25 * footM, 1e-5);
    EXPECT_EQ(trees_[4].heightSource, TreeSource::assumed);
    EXPECT_EQ(count(noNumber), 1U);
}

TEST_F(TreeInventories, AFieldThatTheUserChoosesCountsInItsUnit) {
    const TreeReading how{
        .fields = {parseTreeFieldChoice("height=Size:ft").value(), parseTreeFieldChoice("stem=").value()}};
    read("trees.csv", "Size,dbh,lon,lat\n30,900,13.4,52.5\n", how);
    EXPECT_NEAR(trees_[0].heightM, 30 * footM, 1e-5);
    EXPECT_EQ(count(tooMuch), 0U) << "the stem is not read";
    EXPECT_FALSE(parseTreeFieldChoice("size=Size"));
    EXPECT_EQ(parseTreeFieldChoice("height=a:b").value().field, "a:b");
}

TEST_F(TreeInventories, ListedFieldsSayWhatTheyHold) {
    const auto listed =
        listTrees(folder_.file("trees.csv", "name,tree_dbh,lon,lat\na,10,13.4,52.5\nb,20,13.4,52.6\n"), {});
    ASSERT_TRUE(listed) << listed.error().text();
    EXPECT_EQ(listed->content, TreeContent::inventory);
    ASSERT_EQ(listed->layers.size(), 1U);
    EXPECT_EQ(listed->layers[0].features, 2U);
    ASSERT_NE(findRole(listed->fields, TreeRole::stemDiameter), nullptr);
    EXPECT_EQ(findRole(listed->fields, TreeRole::stemDiameter)->field, "tree_dbh");
    const auto houses =
        listTrees(folder_.file("houses.csv", "height,WKT\n10,\"POLYGON ((0 0,1 0,1 1,0 0))\"\n"), {});
    ASSERT_TRUE(houses) << houses.error().text();
    EXPECT_EQ(houses->content, TreeContent::none);
}

TEST(JoinTrees, SwappedCoordinatesAreNamed) {
    City city;
    city.frame = Frame({13.4, 52.5}, 0);
    Warnings warnings;
    EXPECT_FALSE(joinTrees({ReadTree{{52.5, 13.4}, {}}}, city, 1000, warnings));
    ASSERT_EQ(warnings.size(), 1U);
    EXPECT_THAT(warnings[0].what, HasSubstr("swapped"));
}

}  // namespace
}  // namespace noonmark
