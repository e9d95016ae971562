#include "core/lab/accrual/surface_accrual.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "core/engines/depths/map_frame.h"
#include "core/engines/depths/slice_stack.h"
#include "core/engines/ray/surface_rays.h"
#include "core/engines/ray/visible_surface.h"
#include "tests/core/engines/scenes.h"

namespace noonmark {
namespace {

using namespace tests;

SunSteps greatCircleHour(double fromAzimuth, double toAzimuth, double altitude) {
    const SunInterval interval{glm::dvec3(towardsSun(fromAzimuth, altitude)),
                               glm::dvec3(towardsSun(toAzimuth, altitude)), 60};
    SunSteps sun;
    sun.days.push_back({.first = 0, .count = 60});
    for (int k = 0; k < 60; ++k)
        sun.steps.push_back({.direction = glm::vec3(glm::normalize(interval.at(k))), .slot = k});
    return sun;
}

SurfacePoints seenFrom(const City& city, glm::dvec3 eye, glm::dvec3 target) {
    return findVisibleSurface(RayScene::over(city).value(), !city.terrain,
                              makeCamera(eye, target, 40, 300, 200))
        .value()
        .points;
}

SurfaceShadow accruedOn(const City& city, const SurfacePoints& points, const SunSteps& sun,
                        const AccrualSettings& settings = {}) {
    NoProgress progress;
    return SurfaceAccrual::make(settings, {.merge = false})
        .value()
        ->accumulate(city, points, sun, progress, {})
        .value();
}

SurfaceShadow tracedOn(const City& city, const SurfacePoints& points, const SunSteps& sun) {
    NoProgress progress;
    return SurfaceRays().accumulate(city, points, sun, progress, {}).value();
}

double meanErrorPercent(const SurfaceShadow& shadow, const SurfaceShadow& truth) {
    double sum = 0;
    for (std::size_t i = 0; i < shadow.grossMin.size(); ++i)
        sum += std::abs(double(shadow.grossMin[i]) - double(truth.grossMin[i]));
    return 100 * sum / (double(shadow.grossMin.size()) * truth.sunlitMinutesPerDay);
}

TEST(SurfaceAccrual, AgreesWithTheRaysOnGroundRoofsAndFacades) {
    for (std::uint32_t seed = 1; seed <= 3; ++seed) {
        const City city = cityOf(randomBoxes(seed, 8));
        const SurfacePoints points = seenFrom(city, {80, -120, 120}, {80, 80, 0});
        const SunSteps sun = greatCircleHour(120, 138, 35);
        EXPECT_LT(meanErrorPercent(accruedOn(city, points, sun), tracedOn(city, points, sun)), 1) << seed;
    }
}

TEST(SurfaceAccrual, FacadesAreDarkWhileTheSunIsBehindThem) {
    const City city = cityOf({{{0, 0, 0}, {10, 10, 20}}});
    const SurfacePoints points{{{10, 5, 8}, {0, 5, 8}, {5, 5, 20}}, {{1, 0, 0}, {-1, 0, 0}, {0, 0, 1}}, {}};
    const SurfaceShadow shadow = accruedOn(city, points, greatCircleHour(80, 100, 30));
    EXPECT_EQ(shadow.grossMin, (std::vector<float>{0, 60, 0}));
    EXPECT_EQ(shadow.continuousMin, (std::vector<float>{0, 60, 0}));
}

TEST(SurfaceAccrual, LitFacesDoNotShadeThemselves) {
    const City city = cityOf({{{0, 0, 0}, {100, 100, 60}}});
    const SunSteps sun = greatCircleHour(150, 160, 20);
    const SurfacePoints points = seenFrom(city, {60, -150, 100}, {50, 50, 30});
    EXPECT_LT(meanErrorPercent(accruedOn(city, points, sun), tracedOn(city, points, sun)), 0.3);
    // In the paper's maps every lit face lies on itself; half a texel of slope bias is needed to clear it.
    const AccrualSettings lit{.side = CasterSide::towardsSun};
    AccrualSettings withSlope = lit;
    withSlope.slopeBias = 1;
    EXPECT_GT(meanErrorPercent(accruedOn(city, points, sun, lit), tracedOn(city, points, sun)), 5);
    EXPECT_LT(meanErrorPercent(accruedOn(city, points, sun, withSlope), tracedOn(city, points, sun)), 1);
}

TEST(SurfaceAccrual, TheWarpHalvesTheErrorOfALowView) {
    const City city = cityOf(randomBoxes(4, 60));
    const SurfacePoints points = seenFrom(city, {-150, -50, 130}, {400, 380, 0});
    const SunSteps sun = greatCircleHour(120, 135, 45);
    const SurfaceShadow truth = tracedOn(city, points, sun);
    const AccrualSettings small{.mapSize = 512};
    AccrualSettings even = small;
    even.warp = false;
    EXPECT_LT(meanErrorPercent(accruedOn(city, points, sun, small), truth),
              meanErrorPercent(accruedOn(city, points, sun, even), truth) / 2);
}

TEST(SurfaceAccrual, HillsThrowShadowsAndDoNotShadeTheirSunnySide) {
    City city;
    Terrain terrain{.grid = {-100, -100, 5, 40, 40}};
    for (int row = 0; row < 40; ++row)
        for (int column = 0; column < 40; ++column) {
            const double x = terrain.grid.centre(column, row).x;
            terrain.elevationM.push_back(float(30 * std::exp(-x * x / 800)));
        }
    city.terrain = std::make_shared<const Terrain>(terrain);
    const SurfacePoints points = seenFrom(city, {0, -250, 200}, {0, 0, 0});
    const SunSteps sun = greatCircleHour(90, 100, 25);
    EXPECT_LT(meanErrorPercent(accruedOn(city, points, sun), tracedOn(city, points, sun)), 1);
}

TEST(SurfaceAccrual, WarpedSlicesEqualSeparateShadowMapsBitForBit) {
    const City city = cityOf(randomBoxes(12, 8));
    const SurfacePoints points = seenFrom(city, {-60, -20, 40}, {100, 80, 0});
    const SunInterval interval{glm::dvec3(towardsSun(120, 30)), glm::dvec3(towardsSun(138, 40)), 60};
    const MapFrame frame = makeSurfaceFrame(points, interval, 256, true);
    EXPECT_NE(frame.texelFromPlane[0][2], 0);  // the map is warped
    std::vector<std::uint32_t> all(city.buildings.size());
    for (std::uint32_t i = 0; i < all.size(); ++i) all[i] = i;
    const CasterFaces faces = makeCasterFaces(city, all);
    const auto placed = frame.placed(faces.points);
    const auto slice = [&](const IntervalCasters& casters, glm::dvec3 sun) {
        DepthSlice drawn(frame.columns, frame.rows);
        SliceDrawer().draw(casters, frame, frame.shearOf(sun), CasterSide::awayFromSun, drawn);
        return drawn.depth;
    };
    const ReceiverExtent anywhere{-1000, {}};
    const auto together = placeCasters(faces, placed, frame, interval, CasterSide::awayFromSun, anywhere);
    for (int k = 0; k < interval.steps; ++k) {
        const glm::dvec3 sun = interval.at(k);
        const auto alone =
            placeCasters(faces, placed, frame, {sun, sun, 1}, CasterSide::awayFromSun, anywhere);
        ASSERT_EQ(slice(together, sun), slice(alone, sun)) << k;
    }
}

TEST(SurfaceAccrual, NothingSeenIsNothingShaded) {
    EXPECT_TRUE(
        accruedOn(cityOf({{{0, 0, 0}, {1, 1, 1}}}), {}, greatCircleHour(90, 100, 20)).grossMin.empty());
}

TEST(SurfaceAccrual, RefusesWhatIsOutOfRange) {
    EXPECT_FALSE(SurfaceAccrual::make({.mapSize = 1}, {}));
    NoProgress progress;
    const SurfacePoints points{{{0, 0, 0}}, {}, {}};
    EXPECT_FALSE(SurfaceAccrual::make({}, {}).value()->accumulate({}, points, greatCircleHour(90, 100, 20),
                                                                  progress, {}));
}

// Martin and Tan's rule: the nearest points get most of the map.
TEST(Trapezoid, HoldsAllPointsAndGivesTheNearestMostOfTheMap) {
    std::vector<glm::dvec2> points;
    for (int i = 1; i <= 300; ++i) {
        const double away = 20 + 2000.0 / i;
        for (const double aside : {-0.3, 0.1, 0.3}) points.emplace_back(5 + away, 7 + aside * away);
    }
    const auto matrix = fitTrapezoid(points, {5, 7}, 100);
    ASSERT_TRUE(matrix);
    EXPECT_GT(glm::determinant(*matrix), 0);
    std::vector<double> along;
    for (const glm::dvec2 point : points) {
        const glm::dvec3 h = *matrix * glm::dvec3(point, 1);
        ASSERT_GT(h.z, 0);
        along.push_back(h.x / h.z);
        EXPECT_GE(h.x / h.z, -0.501);
        EXPECT_LE(h.x / h.z, 99.501);
        EXPECT_GE(h.y / h.z, -0.501);
        EXPECT_LE(h.y / h.z, 99.501);
    }
    std::ranges::sort(along);
    EXPECT_NEAR(along[along.size() * 8 / 10], 80, 1);
}

TEST(Trapezoid, IsNoneWhereThePointsAreEvenOrTheEyeIsAboveThem) {
    std::vector<glm::dvec2> points;
    for (int i = 0; i < 1000; ++i) points.emplace_back(i % 100, i / 100);
    EXPECT_FALSE(fitTrapezoid(points, {-50, 5}, 100));
    EXPECT_FALSE(fitTrapezoid(points, {49.5, 4.5}, 100));
}

}  // namespace
}  // namespace noonmark
