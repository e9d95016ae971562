// Tests the depth maps of an interval in isolation: the content of a slice, and that it equals a shadow map.
#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <numeric>

#include "core/engines/depths/slice_stack.h"
#include "tests/core/engines/scenes.h"

namespace noonmark {
namespace {

using namespace tests;

SunInterval hour(double fromAzimuth, double toAzimuth, double fromAltitude, double toAltitude) {
    return {glm::normalize(glm::dvec3(towardsSun(fromAzimuth, fromAltitude))),
            glm::normalize(glm::dvec3(towardsSun(toAzimuth, toAltitude))), 60};
}

CasterFaces allFaces(const City& city) {
    std::vector<std::uint32_t> all(city.buildings.size());
    std::iota(all.begin(), all.end(), 0U);
    return makeCasterFaces(city, all);
}

/// A city's casters in the frame of a grid.
struct Placed {
    CasterFaces faces;
    MapFrame frame;
    std::vector<glm::dvec3> points;

    Placed(const City& city, const Grid& grid, int mapSize)
        : faces(allFaces(city)), frame(makeGroundFrame(grid, mapSize, false)) {
        for (const glm::vec3 point : faces.points) points.push_back(frame.placed(point));
    }

    [[nodiscard]] DepthSlice slice(const IntervalCasters& casters, glm::dvec3 sun, CasterSide side) const {
        DepthSlice slice(frame.columns, frame.rows);
        SliceDrawer().draw(casters, frame, frame.shearOf(sun), side, slice);
        return slice;
    }
};

// Paper, section 4: on a plane perpendicular to the first sun direction, a point at height w above it moves
// by w tan(angle).
TEST(AccrualMap, TheShearIsTheTanLaw) {
    const SunInterval interval = hour(120, 135, 30, 40);
    MapFrame frame;
    frame.normal = interval.first;
    frame.u = glm::normalize(glm::cross(interval.first, interval.last));
    frame.v = glm::cross(frame.normal, frame.u);
    const double theta = std::acos(glm::dot(interval.first, interval.last));
    for (int k = 0; k < interval.steps; ++k) {
        const glm::dvec2 shear = frame.shearOf(interval.at(k));
        EXPECT_NEAR(shear.x, 0, 1e-12);
        EXPECT_NEAR(std::abs(shear.y), std::tan(k * theta / 59), 1e-9) << k;
    }
}

// Paper, section 4, theorem 1.
TEST(AccrualMap, SlicesEqualSeparateShadowMapsBitForBit) {
    const City city = cityOf(randomBoxes(11, 8));
    const Placed scene(city, {-10, -10, 1, 180, 180}, 256);
    for (const CasterSide side : {CasterSide::towardsSun, CasterSide::awayFromSun}) {
        const SunInterval interval = hour(120, 140, 20, 32);
        const IntervalCasters accrual =
            placeCasters(scene.faces, scene.points, scene.frame, interval, side, {});
        for (int k = 0; k < interval.steps; ++k) {
            const glm::dvec3 sun = interval.at(k);
            const IntervalCasters alone =
                placeCasters(scene.faces, scene.points, scene.frame, {sun, sun, 1}, side, {});
            EXPECT_LT(alone.faces.size(), scene.faces.faces.size());
            EXPECT_EQ(scene.slice(accrual, sun, side).depth, scene.slice(alone, sun, side).depth) << k;
        }
    }
}

TEST(AccrualMap, DepthIsTheHeightOfWhatTheSunMeets) {
    const City city = cityOf({{{10, 10, 0}, {20, 20, 30}}});
    const Placed scene(city, {0, 0, 1, 40, 40}, 40);
    const glm::dvec3 sun(towardsSun(180, 60));  // shadows run north
    const IntervalCasters casters =
        placeCasters(scene.faces, scene.points, scene.frame, {sun, sun, 1}, CasterSide::towardsSun, {});
    const DepthSlice slice = scene.slice(casters, sun, CasterSide::towardsSun);
    const auto at = [&](int column, int row) {
        return slice.depth[std::size_t(row) * slice.stride + std::size_t(column)];
    };
    EXPECT_EQ(at(5, 15), DepthSlice::empty);
    // The southern wall rises from y = 10; the roof's shadow lies 30 / tan 60 farther north.
    EXPECT_NEAR(at(15, 15), 5.5 * std::tan(60 * std::numbers::pi / 180), 1e-4);
    EXPECT_NEAR(at(15, 30), 30, 1e-4);
    EXPECT_EQ(at(15, 38), DepthSlice::empty);
}

TEST(MaskTranspose, SwapsRowsAndColumns) {
    std::mt19937_64 random(1);
    std::array<std::uint64_t, 64> words;
    for (auto& word : words) word = random();
    const auto before = words;
    transpose(words);
    for (unsigned i = 0; i < 64; ++i)
        for (unsigned j = 0; j < 64; ++j) ASSERT_EQ(words[j] >> i & 1, before[i] >> j & 1);
}

}  // namespace
}  // namespace noonmark
