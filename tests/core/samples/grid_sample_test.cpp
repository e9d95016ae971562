#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/samples/sample_city.h"
#include "core/samples/street_axes.h"
#include "tests/core/samples/sample_checks.h"

namespace noonmark {
namespace {

using namespace tests;

City grid(const GridSampleSettings& settings) { return makeGridSample(settings).value(); }

std::size_t trianglesOf(const City& city) { return meshOf(city).mesh.triangles.size(); }

TEST(GridSample, HasExactlyTheNumberAskedFor) {
    for (const int count : {100, 101, 1234, 50000})
        EXPECT_EQ(grid({.buildings = count}).buildings.size(), std::size_t(count));
}

TEST(GridSample, IsTheSameForASeedAndAnotherForAnother) {
    const auto fingerprint = fingerprintOf(grid({.buildings = 300, .seed = 7, .roundness = 3}));
    EXPECT_EQ(fingerprint, fingerprintOf(grid({.buildings = 300, .seed = 7, .roundness = 3})));
    EXPECT_NE(fingerprint, fingerprintOf(grid({.buildings = 300, .seed = 8, .roundness = 3})));
}

// A fingerprint computed on another machine. It changes when the sample does; published results that use the
// sample are then for another city.
TEST(GridSample, IsTheSameOnEveryMachine) {
    EXPECT_EQ(fingerprintOf(grid({.buildings = 300, .seed = 7, .roundness = 3})), 3856521339984108734ULL);
}

TEST(GridSample, EveryBuildingIsAValidSolid) {
    for (const auto& building : grid({.buildings = 3000, .seed = 3, .roundness = 5}).buildings)
        EXPECT_EQ(faultOf(*building), "") << building->sourceId;
}

TEST(GridSample, NoHeightOfItIsMeasured) {
    for (const City& city : {grid({.buildings = 300}), makeCentralParkSouthSample()})
        for (const auto& building : city.buildings)
            for (const Part& part : building->parts) ASSERT_EQ(nameOf(part.heightSource), "made up");
}

TEST(GridSample, BuildingsStandApart) {
    const City city = grid({.buildings = 2000, .roundness = 9});
    EXPECT_EQ(cellsInTwoBuildings(city, bounds(city), 0.5), 0U);
}

TEST(GridSample, StreetsAndTheSkewedAvenueAreFree) {
    const City city = grid({.buildings = 600});
    for (double along = -300; along <= 300; along += 7) {
        EXPECT_FALSE(anyContains(city, StreetAxes{}.localFromStreet({-0.27 * along, along})));
        EXPECT_FALSE(anyContains(
            city, StreetAxes{}.localFromStreet({along, 49})));  // the street north of the middle row
    }
}

TEST(GridSample, HasCourtyardsSetbacksAndCurves) {
    const City city = grid({.buildings = 2000, .roundness = 20});
    std::size_t courts = 0, setbacks = 0, curved = 0;
    for (const auto& building : city.buildings) {
        setbacks += building->parts.size() > 1;
        for (const Part& part : building->parts) {
            courts += !part.footprint.holes.empty();
            curved += part.footprint.outer.size() > 20;
        }
    }
    EXPECT_GT(courts, 50U);
    EXPECT_GT(setbacks, 100U);
    EXPECT_GT(curved, 150U);
}

TEST(GridSample, IsTallerInItsMiddle) {
    const City city = grid({.buildings = 20000});
    std::vector<float> middle, edge;
    for (const auto& building : city.buildings) {
        const double y = bounds(*building).low.y;
        if (std::abs(y) < 600) middle.push_back(topM(*building));
        if (y > 2000) edge.push_back(topM(*building));
    }
    const auto median = [](std::vector<float>& heights) {
        std::nth_element(heights.begin(), heights.begin() + std::ptrdiff_t(heights.size() / 2),
                         heights.end());
        return heights[heights.size() / 2];
    };
    EXPECT_GT(median(middle), 1.5 * median(edge));
    EXPECT_NEAR(median(edge), 15, 3);
    EXPECT_GT(*std::max_element(middle.begin(), middle.end()), 150);
}

TEST(GridSample, TrianglesGrowWithRoundness) {
    EXPECT_NEAR(double(trianglesOf(grid({.buildings = 43000, .roundness = 7}))), 1.01e6, 0.02e6);
    EXPECT_NEAR(double(trianglesOf(grid({.buildings = 43000, .roundness = 25}))), 1.52e6, 0.02e6);
}

TEST(GridSample, SettingsOutOfRangeAreRefusedInWords) {
    const auto textOf = [](const GridSampleSettings& settings) {
        return makeGridSample(settings).error().text();
    };
    EXPECT_THAT(textOf({.buildings = 99}), testing::HasSubstr("100 to 50,000"));
    EXPECT_THAT(textOf({.buildings = 50001}), testing::HasSubstr("100 to 50,000"));
    EXPECT_THAT(textOf({.roundness = -1}), testing::HasSubstr("0 to 64"));
    EXPECT_THAT(textOf({.roundness = 65}), testing::HasSubstr("0 to 64"));
    EXPECT_THAT(textOf({.origin = {200, 0}}), testing::HasSubstr("longitude"));
    EXPECT_THAT(textOf({.origin = {0, std::numeric_limits<double>::quiet_NaN()}}),
                testing::HasSubstr("latitude"));
}

}  // namespace
}  // namespace noonmark
