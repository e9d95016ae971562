#include <gtest/gtest.h>

#include <cmath>

#include "core/io/read_city.h"
#include "core/io/write_city.h"
#include "core/samples/sample_city.h"
#include "tests/core/io/temporary_folder.h"

namespace noonmark {
namespace {

double farthest(const Ring& one, const Ring& other) {
    double maximum = 0;
    for (std::size_t i = 0; i < one.size(); ++i) {
        double nearest = 1e9;
        for (const glm::vec2 point : other)
            nearest = std::min(nearest, std::hypot(double(point.x) - one[i].x, double(point.y) - one[i].y));
        maximum = std::max(maximum, nearest);
    }
    return maximum;
}

void expectSame(const Part& seen, const Part& meant) {
    EXPECT_NEAR(seen.topM, meant.topM, 1e-3) << meant.sourceId;
    EXPECT_NEAR(seen.bottomM, meant.bottomM, 1e-3) << meant.sourceId;
    EXPECT_EQ(seen.isOverhanging, meant.isOverhanging) << meant.sourceId;
    EXPECT_EQ(seen.footprint.outer.size(), meant.footprint.outer.size()) << meant.sourceId;
    EXPECT_LT(farthest(meant.footprint.outer, seen.footprint.outer), 1e-3) << meant.sourceId;
    EXPECT_EQ(seen.footprint.holes.size(), meant.footprint.holes.size()) << meant.sourceId;
}

void expectSame(const Building& seen, const Building& meant) {
    EXPECT_EQ(seen.name, meant.name);
    EXPECT_EQ(seen.status, meant.status);
    ASSERT_EQ(seen.parts.size(), meant.parts.size()) << meant.sourceId;
    for (std::size_t i = 0; i < meant.parts.size(); ++i) expectSame(seen.parts[i], meant.parts[i]);
}

Result<CityRead> thereAndBack(const City& city) {
    const tests::TemporaryFolder folder;
    const auto written = writeCityGeoPackage(folder.path("city.gpkg"), city);
    if (!written) return tl::make_unexpected(written.error());
    ReadSettings settings;
    settings.frame = city.frame;
    NoProgress progress;
    return readCity({folder.path("city.gpkg")}, settings, progress, {});
}

void expectSameCity(const City& city) {
    const auto read = thereAndBack(city);
    ASSERT_TRUE(read) << read.error().text();
    EXPECT_TRUE(read->warnings.empty()) << lineOf(groupWarnings(read->warnings).front());
    ASSERT_EQ(read->city.buildings.size(), city.buildings.size());
    for (std::size_t i = 0; i < city.buildings.size(); ++i)
        expectSame(*read->city.buildings[i], *city.buildings[i]);
}

TEST(CityRoundTrip, CentralParkSouth) { expectSameCity(makeCentralParkSouthSample()); }

TEST(CityRoundTrip, Grid) {
    const auto city = makeGridSample({.buildings = 1000, .seed = 5});
    ASSERT_TRUE(city);
    expectSameCity(*city);
}

TEST(CityRoundTrip, PartsThatHang) {
    Building building{.sourceId = "way 1", .name = "Arch", .status = "to be built"};
    const auto square = [](float x, float side) {
        return Ring{{x, 0}, {x + side, 0}, {x + side, side}, {x, side}};
    };
    building.parts.push_back({.sourceId = "leg", .footprint = {square(0, 10), {}}, .bottomM = 0, .topM = 40});
    building.parts.push_back({.sourceId = "bridge",
                              .footprint = {square(10, 9), {}},
                              .bottomM = 30,
                              .topM = 40,
                              .isOverhanging = true});
    expectSameCity({Frame({15.6, 78.2}), {std::make_shared<const Building>(building)}, nullptr});
}

// Fiji: houses on both sides of 180 degrees, and one across it.
TEST(CityRoundTrip, AcrossTheAntimeridian) {
    expectSameCity(makeGridSample({.buildings = 200, .origin = {180, -16.85}}).value());
}

}  // namespace
}  // namespace noonmark
