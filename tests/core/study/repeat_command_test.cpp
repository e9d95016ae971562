#include "core/study/repeat_command.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "core/study/region_text.h"

namespace noonmark {
namespace {

using namespace std::chrono_literals;

Study aStudy() {
    Study study;
    study.city.frame = Frame(LonLat{-73.984, 40.754});
    study.settings.region = regionFromLocalBox({{0, 0}, {120, 80}});
    study.settings.period.zone = "America/New_York";
    study.settings.engine = "ray";
    return study;
}

TEST(RegionText, ABoxComesBackAsItsFourNumbers) {
    const Frame frame(LonLat{-73.99, 40.74});
    const auto region = regionFromLonLatBox(frame, -73.9873, 40.7510, -73.9790, 40.7570);
    ASSERT_TRUE(region);
    EXPECT_EQ(boxTextOf(*region, frame), "-73.9873,40.751,-73.979,40.757");
}

TEST(RegionText, WhatIsNoBoxIsNotCalledOne) {
    const Frame frame(LonLat{0, 0});
    const Ring cut{{0, 0}, {100, 0}, {100, 60}, {60, 100}, {0, 100}};
    EXPECT_FALSE(boxTextOf({"cut corner", {{cut, {}}}}, frame));
    const Ring triangle{{0, 0}, {100, 0}, {100, 100}};
    EXPECT_FALSE(boxTextOf({"triangle", {{triangle, {}}}}, frame));
    const Ring square{{0, 0}, {100, 0}, {100, 100}, {0, 100}};
    EXPECT_TRUE(boxTextOf({"square", {{square, {}}}}, frame));
    EXPECT_FALSE(boxTextOf({"two", {{square, {}}, {square, {}}}}, frame));
    EXPECT_FALSE(boxTextOf({"none", {}}, frame));
    const Ring hole{{20, 20}, {20, 40}, {40, 40}, {40, 20}};
    EXPECT_FALSE(boxTextOf({"holed", {{square, {hole}}}}, frame));
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
    study.inputs = {{"/data/my city.osm.pbf", 10, "ab"}};
    study.settings.region = *regionFromLonLatBox(study.city.frame, -73.985, 40.753, -73.983, 40.755);
    EXPECT_EQ(
        repeatCommand(study, 1000),
        "noonmark-cli study 'my city.osm.pbf' --start 2026-03-21 --days 1 --from 09:00 --hours 6 --step 1 "
        "--zone America/New_York --region -73.985,40.753,-73.983,40.755 --cell 1 --engine ray --out "
        "repeated");
}

TEST(RepeatCommand, NamesWhatDiffersFromTheDefault) {
    Study study = aStudy();
    study.inputs = {{"it's.gpkg", 10, "ab"},
                    {"-x.shp", 10, "ab"},
                    {"-x.dbf", 10, "ab"},
                    {"-x.tfw", 10, "ab"},
                    {"sample:grid", 0, ""}};
    study.settings.region = {"triangle", {{{{0, 0}, {100, 0}, {100, 100}}, {}}}};
    study.settings.period.window = SolarWindow{90min, 30min};
    study.settings.period.refraction = false;
    study.settings.engine = "iam";
    study.settings.engineSettings = {{"levels", 4}, {"bound", 2.5}};
    study.reading.heightField = "roof height";
    study.reading.heightUnit = LengthUnit::feet;
    EXPECT_EQ(
        repeatCommand(study, 1000),
        "noonmark-cli study 'it'\\''s.gpkg' ./-x.shp sample:grid --height-field 'roof height' --height-unit "
        "ft --start 2026-03-21 "
        "--days 1 --window sunrise+90m..sunset-30m --step 1 --zone America/New_York --no-refraction --region "
        "region.geojson --cell 1 --engine iam --option bound=2.5 --option levels=4 --out repeated");
}

TEST(RepeatCommand, LongLinesGoOnAfterABackslash) {
    Study study = aStudy();
    const std::string whole = repeatCommand(study, 1000);
    std::string wrapped = repeatCommand(study, 60);
    std::size_t lines = 1;
    for (std::size_t at = wrapped.find(" \\\n    "); at != std::string::npos;
         at = wrapped.find(" \\\n    ")) {
        wrapped.erase(at + 1, 6);
        ++lines;
    }
    EXPECT_GT(lines, 3U);
    EXPECT_EQ(wrapped, whole);
}

}  // namespace
}  // namespace noonmark
