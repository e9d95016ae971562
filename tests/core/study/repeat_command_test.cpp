#include "core/study/provenance/repeat_command.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "core/io/read_region.h"
#include "core/study/text/region_text.h"
#include "tests/core/io/temporary_folder.h"

namespace noonmark {
namespace {

using namespace std::chrono_literals;

Study aStudy() {
    Study study;
    study.city.frame = Frame(LonLat{-73.984, 40.754});
    study.settings.region = makeRegionFromLocalBox({{0, 0}, {120, 80}});
    study.settings.period.zone = "America/New_York";
    study.settings.engine = "ray";
    study.provenance.inputs = {{"city.gpkg", 10, "ab"}};
    return study;
}

TEST(RegionText, ABoxComesBackAsItsFourNumbers) {
    const Frame frame(LonLat{-73.99, 40.74});
    const auto region = makeRegionFromLonLatBox(frame, -73.9873, 40.7510, -73.9790, 40.7570);
    ASSERT_TRUE(region);
    EXPECT_EQ(formatBox(*region, frame), "-73.9873,40.751,-73.979,40.757");
}

TEST(RegionText, WhatIsNoBoxIsNotCalledOne) {
    const Frame frame(LonLat{0, 0});
    const Ring cut{{0, 0}, {100, 0}, {100, 60}, {60, 100}, {0, 100}};
    EXPECT_FALSE(formatBox({"cut corner", {{cut, {}}}}, frame));
    const Ring triangle{{0, 0}, {100, 0}, {100, 100}};
    EXPECT_FALSE(formatBox({"triangle", {{triangle, {}}}}, frame));
    const Ring square{{0, 0}, {100, 0}, {100, 100}, {0, 100}};
    EXPECT_FALSE(formatBox({"square", {{square, {}}}}, frame)) << "parallels and meridians bend";
    EXPECT_FALSE(formatBox({"two", {{square, {}}, {square, {}}}}, frame));
    EXPECT_FALSE(formatBox({"none", {}}, frame));
    const Ring hole{{20, 20}, {20, 40}, {40, 40}, {40, 20}};
    EXPECT_FALSE(formatBox({"holed", {{square, {hole}}}}, frame));
}

// Down to a millimetre: finer digits may be lost in the corners' float32; the region then needs a file.
TEST(RegionText, ABoxIsStatedWithAsManyDigitsAsItTakes) {
    const Frame frame(LonLat{-73.99, 40.74});
    for (const double west : {-73.9873, -73.98731234, -74.00000001}) {
        const auto region = makeRegionFromLonLatBox(frame, west, 40.75, -73.979, 40.757);
        const auto back = readRegion(formatBox(*region, frame).value(), frame);
        EXPECT_EQ(back->polygons, region->polygons) << west;
    }
    EXPECT_EQ(formatBox(*makeRegionFromLonLatBox(frame, -73.99, 40.7, -73.9, 40.757), frame),
              "-73.99,40.7,-73.9,40.757");
}

// Corners a few kilometres away, sides of more than 500 m: as drawn in the window and as read from a file.
TEST(RegionText, AnOutlineComesBackFromItsFileToTheLastBit) {
    const tests::TemporaryFolder folder;
    const Frame frame(LonLat{7.4216, 43.7333}, 61.5);
    const Ring drawn{{-1812.3F, -940.17F}, {2120.77F, -701.03F}, {1500.123F, 1333.9F}, {-7.01F, 2.5F}};
    const Ring hole{{100.5F, 10}, {100.5F, 40.25F}, {140, 40.25F}, {140, 10}};
    const auto file = folder.file("drawn.geojson", regionGeoJson({"drawn", {{drawn, {hole}}}}, frame));
    const auto read = readRegion(file.string(), frame);
    ASSERT_TRUE(read) << read.error().text();
    ASSERT_EQ(read->polygons.size(), 1U);
    for (const glm::vec2 corner : drawn)
        EXPECT_EQ(std::ranges::count(read->polygons[0].outer, corner), 1) << corner.x << " " << corner.y;
    EXPECT_NEAR(area(read->polygons[0]), area(Footprint{drawn, {hole}}), 0.01);
    const auto again = folder.file("again.geojson", regionGeoJson(*read, frame));
    EXPECT_EQ(readRegion(again.string(), frame)->polygons, read->polygons);
}

TEST(RegionText, GeoJsonClosesItsRings) {
    const Ring triangle{{0, 0}, {100, 0}, {100, 100}};
    const Ring hole{{60, 20}, {60, 40}, {80, 40}, {80, 20}};
    const Frame frame(LonLat{10, 50});
    const auto json = nlohmann::json::parse(regionGeoJson({"a \"name\"", {{triangle, {hole}}}}, frame));
    EXPECT_EQ(json["properties"]["name"], "a \"name\"");
    const auto& rings = json["geometry"]["coordinates"][0];
    ASSERT_EQ(rings.size(), 2U);
    EXPECT_EQ(rings[0].size(), 4U);
    EXPECT_EQ(rings[0][0], rings[0][3]);
    EXPECT_NEAR(rings[0][0][0].get<double>(), 10, 1e-9);
    EXPECT_NEAR(rings[0][0][1].get<double>(), 50, 1e-9);
}

TEST(RepeatCommand, SaysWhatWasAsked) {
    Study study = aStudy();
    study.provenance.inputs = {{"/data/my city.osm.pbf", 10, "ab"}};
    study.settings.region = *makeRegionFromLonLatBox(study.city.frame, -73.985, 40.753, -73.983, 40.755);
    EXPECT_EQ(
        makeRepeatCommand(study, 1000).value(),
        "noonmark-cli study 'my city.osm.pbf' --start 2026-03-21 --days 1 --from 09:00 --hours 6 --step 1 "
        "--zone America/New_York --region -73.985,40.753,-73.983,40.755 --cell 1 --engine ray --out "
        "repeated");
}

TEST(RepeatCommand, NamesWhatDiffersFromTheDefault) {
    Study study = aStudy();
    study.provenance.inputs = {{"it's.gpkg", 10, "ab"},
                               {"-x.shp", 10, "ab"},
                               {"-x.dbf", 10, "ab"},
                               {"-x.shx", 10, "ab"},
                               {"sample:grid", 0, ""}};
    study.settings.region = {"triangle", {{{{0, 0}, {100, 0}, {100, 100}}, {}}}};
    study.settings.period.window = SolarHours{90min, 30min};
    study.settings.period.refraction = false;
    study.settings.engine = "iam";
    study.settings.engineSettings = {{"levels", 4}, {"bound", 2.5}};
    study.provenance.reading->heightField = "roof height";
    study.provenance.reading->heightUnit = LengthUnit::feet;
    EXPECT_EQ(
        makeRepeatCommand(study, 1000).value(),
        "noonmark-cli study 'it'\\''s.gpkg' ./-x.shp sample:grid --height-field 'roof height' --height-unit "
        "ft --start 2026-03-21 "
        "--days 1 --window sunrise+1.5h..sunset-0.5h --step 1 --zone America/New_York --no-refraction "
        "--region "
        "region.geojson --cell 1 --engine iam --option bound=2.5 --option levels=4 --out repeated");
}

ProjectRecord aProject(const std::string& file, const std::string& fileSha256) {
    return {file, fileSha256, "cc", {"It's taller", {"Height of b: 60 m"}, "dd"}, std::nullopt};
}

TEST(RepeatCommand, AProjectIsNamedWithItsScenario) {
    Study study = aStudy();
    study.provenance.reading->heightField = "of another file";
    study.provenance.project = aProject("-my plan.noonmark.gpkg", "ab");
    study.provenance.region = "--odd name";
    EXPECT_EQ(
        makeRepeatCommand(study, 1000).value(),
        "noonmark-cli study './-my plan.noonmark.gpkg' --scenario 'It'\\''s taller' --start 2026-03-21 "
        "--days 1 --from 09:00 --hours 6 --step 1 --zone America/New_York --region='--odd name' --cell 1 "
        "--engine ray --out repeated");
}

TEST(RepeatCommand, AnUnsavedScenarioHasNone) {
    Study study = aStudy();
    for (const auto& project : {aProject("", ""), aProject("plan.noonmark.gpkg", "")}) {
        study.provenance.project = project;
        const auto repeat = makeRepeatCommand(study);
        ASSERT_FALSE(repeat) << *repeat;
        EXPECT_NE(repeat.error().text().find("Save the project"), std::string::npos);
        EXPECT_EQ(repeat.error().text().find("city.gpkg"), std::string::npos);
    }
    study.provenance.project = aProject("", "");
    study.provenance.project->scenario = {"Existing", {}, "dd"};
    EXPECT_EQ(makeRepeatCommand(study).value().rfind("noonmark-cli study city.gpkg", 0), 0U)
        << "the city as it stands is that of its files";
    study.provenance.reading.reset();
    EXPECT_FALSE(makeRepeatCommand(study)) << "how they were read is not known";
    study.provenance = {};
    EXPECT_FALSE(makeRepeatCommand(study)) << "nor which they are";
}

TEST(RepeatCommand, FilesOfOneNameAreToldApart) {
    Study study = aStudy();
    study.provenance.inputs = {{"/a/city.gpkg", 10, "ab"}, {"/b/city.gpkg", 10, "cd"}};
    EXPECT_EQ(makeRepeatCommand(study, 1000).value().rfind("noonmark-cli study /a/city.gpkg /b/city.gpkg", 0),
              0U);
}

TEST(RepeatCommand, LongLinesGoOnAfterABackslash) {
    Study study = aStudy();
    const std::string whole = makeRepeatCommand(study, 1000).value();
    std::string wrapped = makeRepeatCommand(study, 60).value();
    std::size_t lines = 1;
    for (std::size_t at = wrapped.find(" \\\n    "); at != std::string::npos;
         at = wrapped.find(" \\\n    ")) {
        wrapped.erase(at + 1, 6);
        ++lines;
    }
    EXPECT_GT(lines, 3U);
    EXPECT_EQ(wrapped, whole);
}

TEST(RepeatReview, NamesProjectRuleScenariosAndPlacesOnce) {
    ReviewStudy study;
    study.rule.key = "japan";
    study.rule.chosen = {{"plane", "4 m"}};
    study.settings = {0.5, "Asia/Tokyo", 2026};
    study.year = 2026;
    study.places = {{.name = "Lot 1"}, {.name = "Lot 1"}, {.name = "it's"}};
    ReviewLabels labels{"Existing", "Tower A", {}};
    EXPECT_FALSE(makeRepeatCommand(study, labels)) << "no project";
    labels.provenance.project = ProjectRecord{.file = "p.noonmark.gpkg", .fileSha256 = "ab"};
    EXPECT_EQ(
        makeRepeatCommand(study, labels, 1000).value(),
        "noonmark-cli review run p.noonmark.gpkg --rule japan --choose 'plane=4 m' --from Existing --to "
        "'Tower A' --places 'Lot 1' 'it'\\''s' --year 2026 --zone Asia/Tokyo --cell 0.5 --out repeated");
    labels.places = {"all"};
    labels.sheets = {{"--paper", {"A3"}}, {"--landscape", {}}};
    study.rule.file = "/home/x/rules/own.json";
    study.rule.chosen = {};
    EXPECT_EQ(makeRepeatCommand(study, labels, 1000).value(),
              "noonmark-cli review run p.noonmark.gpkg --rule japan --rules . --from Existing --to 'Tower A' "
              "--places all --year 2026 --zone Asia/Tokyo --cell 0.5 --paper A3 --landscape --out repeated");
}

}  // namespace
}  // namespace noonmark
