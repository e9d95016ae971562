#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <numeric>

#include "core/engines/depths/sun_depth_map.h"
#include "tests/core/engines/scenes.h"

namespace noonmark {
namespace {

CasterFaces allFaces(const City& city) {
    std::vector<std::uint32_t> all(city.buildings.size());
    std::iota(all.begin(), all.end(), 0U);
    return makeCasterFaces(city, all);
}

constexpr LitSpace around{{{-100, -100}, {100, 100}}, 0, 30};

// A tower of 20 m x 20 m x 30 m with the sun 45 degrees high in the south: its shadow is 30 m long.
TEST(SunDepthMap, ATowersShadowIsAsLongAsItIsHighAtFortyFiveDegrees) {
    const City city = tests::cityOf({{{-10, -10, 0}, {10, 10, 30}}});
    const SunDepthMap map = drawSunDepths(allFaces(city), glm::normalize(glm::dvec3(0, -1, 1)), around, 1024);
    const double bias = 0.05;
    EXPECT_TRUE(map.shades({0, 15, 0}, bias));
    EXPECT_TRUE(map.shades({0, 39, 0}, bias));
    EXPECT_FALSE(map.shades({0, 41, 0}, bias));
    EXPECT_FALSE(map.shades({0, -12, 0}, bias)) << "in front of it";
    EXPECT_FALSE(map.shades({12, 20, 0}, bias)) << "beside its shadow";
    EXPECT_FALSE(map.shades({0, 0, 30}, bias)) << "its own roof is in the sun";
    EXPECT_TRUE(map.shades({0, 20, 19}, bias)) << "10 m behind it the shadow reaches 30 - 10 m high";
    EXPECT_FALSE(map.shades({0, 20, 21}, bias));
    EXPECT_FALSE(map.shades({0, 500, 0}, bias)) << "outside of the map";
}

TEST(SunDepthMap, OccludersOutsideOfTheSpaceCastIntoIt) {
    const City city = tests::cityOf({{{-10, -130, 0}, {10, -110, 60}}});
    const SunDepthMap map = drawSunDepths(allFaces(city), glm::normalize(glm::dvec3(0, -2, 1)), around, 512);
    EXPECT_TRUE(map.shades({0, -50, 0}, 0.05));
    EXPECT_TRUE(map.shades({0, 8, 0}, 0.05));
    EXPECT_FALSE(map.shades({0, 12, 0}, 0.05));
}

}  // namespace
}  // namespace noonmark
