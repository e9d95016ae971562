#include "render/scene/city_arrays.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <glm/geometric.hpp>

#include "app/gui/view/panel/ground_layers.h"
#include "render/scene/ground_picture.h"
#include "tests/gui/small_city.h"

namespace noonmark {
namespace {

TEST(FeatureEdges, ABoxHasTwelve) {
    Part box;
    box.footprint = test::square({0, 0}, 10);
    box.topM = 20;
    EXPECT_EQ(findFeatureEdges(meshOf(box)).size(), 2U * 12);
}

TEST(FeatureEdges, APlaneShowsItsBorderOnly) {
    const TriangleMesh plane{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 3}}};
    EXPECT_EQ(findFeatureEdges(plane).size(), 2U * 4);
}

TEST(CityArrays, EdgesAreLeftOutAboveTheLimit) {
    EXPECT_FALSE(makeArrays(test::smallCity()).edges.empty());
    EXPECT_TRUE(makeArrays(test::smallCity(), 3).edges.empty());
}

TEST(CityArrays, GroundReachesFarBeyondTheCity) {
    const CityArrays arrays = makeArrays(test::smallCity());
    const auto [low, high] = std::ranges::minmax(arrays.groundPoints, {}, [](glm::vec3 p) { return p.x; });
    EXPECT_LT(low.x, arrays.bounds.box.low.x - 1000);
    EXPECT_GT(high.x, arrays.bounds.box.high.x + 1000);
}

TEST(CityArrays, KnowWhereEachBuildingLies) {
    const CityArrays arrays = makeArrays(test::smallCity());
    ASSERT_EQ(arrays.triangleStart.size(), 4U);
    EXPECT_EQ(arrays.triangleStart.back(), arrays.triangles.size());
    EXPECT_EQ(arrays.edgeStart.back(), arrays.edges.size());
    for (std::size_t building = 0; building < 3; ++building) {
        EXPECT_EQ(arrays.edgeStart[building + 1] - arrays.edgeStart[building], 2U * 12);
        for (std::size_t i = arrays.triangleStart[building]; i < arrays.triangleStart[building + 1]; ++i)
            EXPECT_EQ(arrays.buildingOfPoint[arrays.triangles[i]], float(building));
        for (std::size_t i = arrays.edgeStart[building]; i < arrays.edgeStart[building + 1]; ++i)
            EXPECT_EQ(arrays.buildingOfPoint[arrays.edges[i]], float(building));
    }
}

TEST(DemolishedLines, GoAroundWhatIsGoneAndNotAroundWhatChanged) {
    City city = test::smallCity();
    const CityArrays arrays = makeArrays(city);
    city.buildings[1] = std::make_shared<const Building>(*city.buildings[1]);  // changed, with its id
    city.buildings.erase(city.buildings.begin());
    const auto lines = makeDemolishedLines(arrays, computeDifference(arrays, city), city);
    ASSERT_EQ(lines.size(), 1U);
    EXPECT_TRUE(lines[0].closed);
    Box2 box;
    for (const glm::vec3 point : lines[0].points) box.add(glm::vec2(point));
    EXPECT_EQ(box, bounds(*arrays.buildings[0])) << "the South House";
}

TEST(CityArrays, ACityThatSharesItsBuildingsDiffersByTheOthers) {
    City city = test::smallCity();
    const CityArrays arrays = makeArrays(city);
    EXPECT_TRUE(computeDifference(arrays, city).removed.empty());
    city.buildings[1] = std::make_shared<const Building>(*city.buildings[1]);
    city.buildings.erase(city.buildings.begin());
    const ArrayDifference difference = computeDifference(arrays, city);
    EXPECT_EQ(difference.removed, (std::vector<std::uint32_t>{0, 1}));
    ASSERT_EQ(difference.added.buildings.size(), 1U);
    EXPECT_EQ(difference.added.buildings.front(), city.buildings.front());
}

TEST(CityArrays, AnEmptyCityStillHasAView) {
    const ViewBounds view = computeViewBounds(City{});
    EXPECT_FALSE(view.box.empty());
    EXPECT_GT(view.radiusM(), 100);
}

TEST(CityArrays, TerrainIsTheGround) {
    City city;
    Terrain terrain;
    terrain.grid = {-50, -50, 10, 10, 10};
    terrain.elevationM.assign(100, 7);
    terrain.elevationM[55] = 42;
    city.terrain = std::make_shared<const Terrain>(terrain);
    const CityArrays arrays = makeArrays(city);
    EXPECT_FLOAT_EQ(arrays.bounds.groundM, 7);
    EXPECT_FLOAT_EQ(arrays.bounds.topM, 42);
    EXPECT_EQ(arrays.groundTriangles.size(), 3U * (2 * 9 * 9 + 2 * 36 + 2));
    for (std::size_t i = 3 * 2 * 9 * 9; i < arrays.groundTriangles.size(); i += 3) {
        const auto at = [&](std::size_t corner) {
            return arrays.groundPoints[arrays.groundTriangles[i + corner]];
        };
        EXPECT_GT(glm::cross(at(1) - at(0), at(2) - at(0)).z, 0) << "the ground around faces up";
        EXPECT_LE(at(0).z, 7) << "and goes on from the border";
        EXPECT_GT(at(0).z, 5);
    }
}

TEST(GroundPicture, WhatFitsIsLeftAlone) {
    const GroundPicture picture{{0, 0, 1, 3, 2}, std::vector<GroundPicture::Pixel>(6, {1, 2, 3, 4})};
    EXPECT_EQ(fitPicture(picture, 3).pixels, picture.pixels);
}

TEST(GroundPicture, TooManyPixelsAreAveragedInPlace) {
    using Pixel = GroundPicture::Pixel;
    const GroundPicture picture{
        {100, 200, 2, 3, 2},
        {{0, 0, 0, 0}, {8, 8, 8, 8}, {40, 0, 0, 0}, {4, 4, 4, 4}, {4, 4, 4, 4}, {80, 0, 0, 0}}};
    const GroundPicture small = fitPicture(picture, 2);
    EXPECT_EQ(small.grid, (Grid{100, 200, 4, 2, 1}));
    EXPECT_EQ(small.pixels, (std::vector<Pixel>{{4, 4, 4, 4}, {60, 0, 0, 0}}));
}

}  // namespace
}  // namespace noonmark
