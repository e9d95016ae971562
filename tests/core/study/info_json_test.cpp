#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "core/study/provenance/command_text.h"
#include "core/study/study.h"
#include "core/study/text/height_facts_text.h"

namespace noonmark {
namespace {

Ring square(float x, float y, float side) {
    return {{x, y}, {x + side, y}, {x + side, y + side}, {x, y + side}};
}

CityRead twoBuildings() {
    Building house{.sourceId = "way 1", .name = "House"};
    house.parts.push_back({.footprint = {square(0, 0, 10), {}},
                           .bottomM = 20,
                           .topM = 29,
                           .heightSource = HeightSource::levels});
    Building tower{.sourceId = "way 2", .name = "Bad \xff name"};
    tower.parts.push_back({.footprint = {square(30, 0, 10), {}},
                           .bottomM = 5,
                           .topM = 45,
                           .heightSource = HeightSource::measured});
    tower.parts.push_back({.footprint = {square(40, 0, 10), {}},
                           .bottomM = 35,
                           .topM = 40,
                           .heightSource = HeightSource::measured,
                           .isOverhanging = true});
    CityRead read;
    read.city.frame = Frame({-73.98, 40.75});
    read.city.buildings = {std::make_shared<const Building>(house), std::make_shared<const Building>(tower)};
    read.format = "GeoJSON";
    read.features = 5;
    read.warnings = {{WarningKind::repaired, "outline crossed itself", "way 2"},
                     {WarningKind::repaired, "outline crossed itself", "way 9"}};
    return read;
}

TEST(InfoJson, CountsWhatIsThere) {
    const auto info = nlohmann::json::parse(infoJson(twoBuildings()));
    EXPECT_EQ(info["buildings"], 2);
    EXPECT_EQ(info["parts"], 3);
    EXPECT_EQ(info["parts_hanging"], 1);
    EXPECT_EQ(info["triangles"], 3 * 12);
    EXPECT_EQ(
        info["height_sources"],
        (nlohmann::json{
            {"measured", 2}, {"levels", 1}, {"assumed", 0}, {"mesh", 0}, {"designed", 0}, {"made up", 0}}));
    EXPECT_EQ(info["tallest_m"], 40.0);  // above the building's own ground
    EXPECT_EQ(info["features"], 5);
    ASSERT_EQ(info["warnings"].size(), 1U);
    EXPECT_EQ(info["warnings"][0]["count"], 2);
    EXPECT_EQ(info["warnings"][0]["where"], (nlohmann::json{"way 2", "way 9"}));
}

TEST(InfoJson, StatesTheRangesOfHeightsAndGround) {
    const auto info = nlohmann::json::parse(infoJson(twoBuildings()));
    EXPECT_EQ(info["height_ranges_m"], (nlohmann::json{{"measured", {5.0, 40.0}}, {"levels", {9.0, 9.0}}}));
    EXPECT_EQ(info["ground_m"], (nlohmann::json{5.0, 20.0}));
    EXPECT_TRUE(nlohmann::json::parse(infoJson({}))["ground_m"].is_null());
}

TEST(InfoJson, CountsWhatReadingChanged) {
    CityRead read = twoBuildings();
    read.crs = "WGS 84, as the file states";
    read.warnings.push_back(
        {WarningKind::leftOut, "a second building of the same id at the same place", "a"});
    read.warnings.push_back({WarningKind::leftOut, "far away", "b"});
    const auto info = nlohmann::json::parse(infoJson(read));
    EXPECT_EQ(info["changes"], (nlohmann::json{{"repaired", 2},
                                               {"clipped", 0},
                                               {"dropped", 0},
                                               {"left_out", 2},
                                               {"assumed", 0},
                                               {"duplicates", 1}}));
    EXPECT_EQ(describeChanges(read.warnings), "2 repaired, 2 left out, 1 duplicates");
    EXPECT_EQ(describeChanges({}), "nothing");
    const std::string text = summariseReading(read);
    EXPECT_TRUE(text.starts_with("GeoJSON (WGS 84, as the file states), ")) << text;
    EXPECT_NE(text.find("United States. Buildings: 2, parts: 3, up to 40 m high. On flat ground. Changed in "
                        "reading: 2 repaired"),
              std::string::npos)
        << text;
}

// 2 x 2 posts, 4 km east of the origin, where the earth's surface has dropped by 1.26 m; light bends after it
// by 13 % of that.
TEST(InfoJson, StatesTheElevationsOfTheTerrain) {
    CityRead read = twoBuildings();
    EXPECT_TRUE(nlohmann::json::parse(infoJson(read))["terrain_m"].is_null());
    const auto drop = float(earthDropM({4000, 0}));
    EXPECT_NEAR(drop, 1.26 * 0.87, 0.01);
    read.city.frame = Frame({-73.98, 40.75}, 100);
    read.city.terrain = std::make_shared<const Terrain>(
        Terrain{{4000, 0, 1, 2, 2}, {5 - drop, 6 - drop, 7 - drop, 8 - drop}, {}});
    const auto range = nlohmann::json::parse(infoJson(read))["terrain_m"];
    EXPECT_NEAR(range[0], 105, 0.01);
    EXPECT_NEAR(range[1], 108, 0.01);
}

TEST(InfoJson, BytesThatAreNoTextDoNotBreakIt) {
    const auto info = nlohmann::json::parse(infoJson(twoBuildings()));
    EXPECT_EQ(info["tallest"], "Bad \xEF\xBF\xBD name");
}

City ofHeights(std::size_t assumed, std::size_t measured, float topM = 9.6F) {
    Building all{.sourceId = "all"};
    for (std::size_t i = 0; i < assumed + measured; ++i)
        all.parts.push_back({.footprint = {square(float(20 * i), 0, 10), {}},
                             .topM = topM,
                             .heightSource = i < assumed ? HeightSource::assumed : HeightSource::measured});
    City city;
    city.buildings = {std::make_shared<const Building>(all)};
    return city;
}

TEST(AssumedHeights, AreAHeadlineAboveATenth) {
    EXPECT_EQ(makeAssumedHeadline(countHeights(ofHeights(10, 90))), std::nullopt);
    EXPECT_EQ(makeAssumedHeadline(countHeights(ofHeights(11, 89))), "11 of 100 heights are assumed (9.6 m)");
    EXPECT_EQ(makeAssumedHeadline(countHeights(ofHeights(2133, 0))),
              "2,133 of 2,133 heights are assumed (9.6 m)");
    EXPECT_EQ(makeAssumedHeadline(countHeights(City{})), std::nullopt);
    City mixed = ofHeights(3, 0);
    mixed.buildings.push_back(ofHeights(1, 0, 3.2F).buildings[0]);
    EXPECT_EQ(makeAssumedHeadline(countHeights(mixed)), "4 of 4 heights are assumed (most of them 9.6 m)");
}

// Of ten trees one height and two crowns: only the crowns are more than a tenth.
TEST(AssumedHeights, AndCrownsOfTreesAreAHeadline) {
    City city = ofHeights(11, 89);
    Trees trees;
    for (int i = 0; i < 10; ++i) trees.trees.push_back({.heightSource = TreeSource::measured});
    for (Tree& tree : trees.trees) tree.crownSource = TreeSource::designed;
    const auto headlines = [&] {
        city.trees = std::make_shared<const Trees>(trees);
        return listGeometryHeadlines(city, {});
    };
    trees.trees[0].heightSource = TreeSource::estimated;
    trees.trees[0].crownSource = TreeSource::assumed;
    ASSERT_EQ(headlines().size(), 1U) << "a tenth of each is not said";
    trees.trees[1].crownSource = TreeSource::estimated;
    const auto said = headlines();
    ASSERT_EQ(said.size(), 2U);
    EXPECT_EQ(said[0].text, "11 of 100 heights are assumed (9.6 m)");
    EXPECT_EQ(said[1].of, "heights of trees");
    EXPECT_EQ(said[1].text, "Estimated or assumed of 10 trees: height of 1, crown of 2");
    EXPECT_EQ(formatText(describeHeights(city, {}).back()), said[1].text);
}

TEST(AssumedHeights, AreCountedInJsonWithTheFieldsOfTheOthers) {
    CityRead read;
    read.city = ofHeights(1, 3);
    read.heights.fields = {{"a.shp", "RelH2", "base of the roof", "m", 3}};
    read.heights.unknown = {{"a.shp", "H_BAT", 2.5, 41, false, 4}};
    const auto heights = nlohmann::json::parse(infoJson(read))["heights"];
    EXPECT_EQ(heights["by_source"]["measured"], 3);
    EXPECT_EQ(heights["assumed_share"], 0.25);
    EXPECT_EQ(heights["assumed_m"], 9.6);
    EXPECT_EQ(heights["fields"][0]["field"], "RelH2");
    EXPECT_EQ(heights["fields"][0]["meaning"], "base of the roof");
    EXPECT_EQ(heights["fields"][0]["unit"], "m");
    EXPECT_EQ(heights["could_be"][0]["high"], 41);
    const auto said = describeHeights(read.city, read.heights);
    ASSERT_EQ(said.size(), 2U);
    EXPECT_EQ(formatText(said[0]), "1 of 4 heights are assumed (9.6 m)");
    EXPECT_EQ(formatText(said[1]),
              "Fields that could hold heights or storeys: H_BAT (2.5 to 41 in 4 features)");
}

TEST(BaseFits, ComeBackFromTheirJsonAndMakeAHeadline) {
    HeightFacts facts;
    facts.bases = {{"a.obj", 12, -20.5, 0.25, StandRule::shifted, 1, 2}, {"b.shp", 3, 0.5, 0.25}};
    EXPECT_EQ(parseHeightFacts(heightFactsJson(facts).dump()), facts);
    EXPECT_EQ(makeStandHeadline(facts),
              "Bases of a.obj lie 20.5 m below the terrain (median of 12, spread 0.2 m); all were shifted "
              "onto it; 2 "
              "far from that gap were set down by themselves; 1 stay above the ground");
    facts.bases.erase(facts.bases.begin());
    EXPECT_EQ(makeStandHeadline(facts), std::nullopt);
}

TEST(NextSteps, NameTheFieldTheTerrainAndAFirstStudy) {
    CityRead read = twoBuildings();
    const auto steps = listNextSteps(read, {"my town.shp"}, {.crs = "EPSG:2263"});
    ASSERT_EQ(steps.size(), 3U);
    EXPECT_EQ(steps[0].command, "noonmark-cli info 'my town.shp' TERRAIN.tif --crs EPSG:2263");
    EXPECT_EQ(steps[1].command.find("noonmark-cli study 'my town.shp' --crs EPSG:2263 --start"), 0U);
    EXPECT_NE(steps[1].command.find(" --window sunrise..sunset "), std::string::npos) << "needs no zone";
    EXPECT_EQ(steps[2].command, "noonmark-cli project new city.noonmark.gpkg 'my town.shp' --crs EPSG:2263");
    EXPECT_EQ(listNextSteps(read, {"town.gml"}, {})[2].command, "noonmark town.gml");
    EXPECT_TRUE(listNextSteps({}, {"a"}, {}).empty());
}

TEST(NextSteps, BeginWithTheFieldThatMayHoldTheHeights) {
    CityRead read;
    read.city = ofHeights(2, 1);
    read.heights.unknown = {{"a.shp", "H_BAT", 2.5, 41, false, 4, FieldKind::heights}};
    const auto steps = listNextSteps(read, {"a.shp"}, {});
    ASSERT_FALSE(steps.empty());
    EXPECT_EQ(steps[0].command, "noonmark-cli info a.shp --height-field H_BAT");
}

TEST(NextSteps, OfferTheHeightsThatASurfaceModelShows) {
    CityRead read;
    read.city = ofHeights(2, 1);
    Terrain terrain;
    terrain.source.underBuildings = 40;
    read.city.terrain = std::make_shared<const Terrain>(terrain);
    const std::vector<std::string> files{"a.shp", "dsm.tif"};
    EXPECT_EQ(listNextSteps(read, files, {})[0].command,
              "noonmark-cli info a.shp dsm.tif --heights-from-surface");
    const auto taken = listNextSteps(read, files, {.heightsFromSurface = true});
    EXPECT_NE(taken[0].why, listNextSteps(read, files, {})[0].why);
}

TEST(InfoJson, ATerrainAloneHasAPlaceToo) {
    CityRead read;
    read.city.frame = Frame({13.4, 52.5});
    Terrain terrain{.grid = PostGrid(-500, -500, 10, 100, 100), .elevationM = std::vector<float>(10'000, 34)};
    read.city.terrain = std::make_shared<const Terrain>(terrain);
    const auto info = nlohmann::json::parse(infoJson(read));
    ASSERT_TRUE(info["extent_lonlat"].is_array());
    EXPECT_NEAR(info["extent_lonlat"][0].get<double>(), 13.4 - 0.00734, 2e-4);
    EXPECT_NEAR(info["extent_lonlat"][3].get<double>(), 52.5 + 0.00448, 2e-4);
}

TEST(InfoJson, AnEmptyCity) {
    const auto info = nlohmann::json::parse(infoJson({}));
    EXPECT_EQ(info["buildings"], 0);
    EXPECT_EQ(info["tallest_m"], 0.0);
    EXPECT_TRUE(info["extent_lonlat"].is_null());
    EXPECT_TRUE(info["warnings"].empty());
    EXPECT_TRUE(info["warnings"].is_array());
}

}  // namespace
}  // namespace noonmark
