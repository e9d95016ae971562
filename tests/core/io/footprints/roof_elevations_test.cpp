#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "core/io/read_city.h"
#include "tests/core/io/footprint_files.h"
#include "tests/core/io/terrain_files.h"

// Roofs whose elevation is known, with and without the ground.
namespace noonmark::tests {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;

double slope(double x, double /*y*/) { return 200 + x / 20; }

class RoofElevations : public testing::Test {
protected:
    // Nine houses in a row, 10 m high above the lowest ground below them.
    static std::string houses(const std::function<std::string(double groundM)>& properties) {
        std::string features;
        for (int i = 0; i < 9; ++i)
            features += (i > 0 ? "," : "") + feature(sizedRectangle(float(20 * i - 80), 0, 10, 10),
                                                     properties(slope(20 * i - 80, 0)));
        return features;
    }
    CityRead read(const std::string& features, bool withHill) {
        std::vector<std::filesystem::path> files{
            folder.file("a.geojson", R"({"type":"FeatureCollection","features":[)" + features + "]}")};
        if (withHill) files.push_back(writeTerrain(folder.path("hill.tif"), manhattan, slope));
        NoProgress quiet;
        auto result = readCity(files, settings, quiet, {});
        EXPECT_TRUE(result) << result.error().text();
        return result ? *std::move(result) : CityRead();
    }
    static double heightOf(const CityRead& read, std::size_t i) {
        const Part& part = read.city.buildings.at(i)->parts.at(0);
        return double(part.topM) - double(part.bottomM);
    }
    static bool warns(const CityRead& read, std::string_view what) {
        return std::ranges::any_of(
            read.warnings, [&](const Warning& one) { return one.what.find(what) != std::string::npos; });
    }

    const std::string absolute =
        houses([](double groundM) { return fmt::format(R"("absolute_height":{})", groundM + 10); });
    TemporaryFolder folder;
    ReadSettings settings;
};

TEST_F(RoofElevations, CountFromTheTerrain) {
    const CityRead read = this->read(absolute, true);
    for (std::size_t i = 0; i < 9; ++i) EXPECT_NEAR(heightOf(read, i), 10, 0.1);
    ASSERT_EQ(read.heights.fields.size(), 1U);
    EXPECT_EQ(read.heights.fields[0], (HeightField{"a.geojson", "absolute_height - terrain", "", "m", 9}));
    EXPECT_TRUE(read.heights.unknown.empty());
    EXPECT_FALSE(warns(read, "is assumed"));
    EXPECT_FALSE(warns(read, "no field of heights"));
    settings.heightField = "absolute_height";
    EXPECT_NEAR(heightOf(this->read(absolute, true), 8), 10, 0.1) << "chosen, too";
}

TEST_F(RoofElevations, GiveNoHeightWithoutAnyGroundUnlessChosen) {
    const CityRead alone = read(absolute, false);
    EXPECT_NEAR(heightOf(alone, 0), 9.6, 1e-3);
    EXPECT_TRUE(warns(alone, "gives no height without the ground's"));
    settings.heightField = "absolute_height";
    const CityRead chosen = read(absolute, false);
    EXPECT_NEAR(heightOf(chosen, 0), 206, 1e-3);
    EXPECT_TRUE(warns(chosen, "since you chose it"));
}

TEST_F(RoofElevations, ArePairedWithAGroundHeight) {
    for (const auto& [roof, ground] :
         {std::pair{"absolute_height", "ground_height"}, {"Höhe_NHN", "Geländehöhe"}}) {
        const CityRead pair =
            read(houses([&](double groundM) {
                     return fmt::format(R"("{}":{},"{}":{})", roof, groundM + 10, ground, groundM);
                 }),
                 false);
        EXPECT_NEAR(heightOf(pair, 3), 10, 0.1) << roof;  // on a terrain from their bases
        EXPECT_FALSE(warns(pair, "is assumed")) << roof;
    }
}

}  // namespace
}  // namespace noonmark::tests
