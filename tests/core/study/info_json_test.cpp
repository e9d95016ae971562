#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "core/study/study.h"

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
                           .hangs = true});
    CityRead read;
    read.city.frame = Frame({-73.98, 40.75});
    read.city.buildings = {std::make_shared<const Building>(house), std::make_shared<const Building>(tower)};
    read.format = "GeoJSON";
    read.features = 5;
    read.warnings = {{WarningKind::mended, "outline crossed itself", "way 2"},
                     {WarningKind::mended, "outline crossed itself", "way 9"}};
    return read;
}

TEST(InfoJson, countsWhatIsThere) {
    const auto info = nlohmann::json::parse(infoJson(twoBuildings()));
    EXPECT_EQ(info["buildings"], 2);
    EXPECT_EQ(info["parts"], 3);
    EXPECT_EQ(info["parts_hanging"], 1);
    EXPECT_EQ(info["triangles"], 3 * 12);
    EXPECT_EQ(info["height_sources"],
              (nlohmann::json{{"measured", 2},
                              {"levels", 1},
                              {"assumed", 0},
                              {"mesh", 0},
                              {"designed", 0},
                              {"made up", 0}}));
    EXPECT_EQ(info["tallest_m"], 40.0);  // above its own ground
    EXPECT_EQ(info["features"], 5);
    ASSERT_EQ(info["warnings"].size(), 1U);
    EXPECT_EQ(info["warnings"][0]["count"], 2);
    EXPECT_EQ(info["warnings"][0]["where"], (nlohmann::json{"way 2", "way 9"}));
}

TEST(InfoJson, bytesThatAreNoTextDoNotBreakIt) {
    const auto info = nlohmann::json::parse(infoJson(twoBuildings()));
    EXPECT_EQ(info["tallest"], "Bad \xEF\xBF\xBD name");
}

TEST(InfoJson, anEmptyCity) {
    const auto info = nlohmann::json::parse(infoJson({}));
    EXPECT_EQ(info["buildings"], 0);
    EXPECT_EQ(info["tallest_m"], 0.0);
    EXPECT_TRUE(info["extent_lonlat"].is_null());
    EXPECT_TRUE(info["warnings"].empty());
    EXPECT_TRUE(info["warnings"].is_array());
}

}  // namespace
}  // namespace noonmark
