#include "core/engines/points/skyline.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

#include "core/engines/points/point_sunlight.h"
#include "core/engines/points/sky_factors.h"
#include "core/engines/ray/surface_rays.h"
#include "tests/core/engines/scenes.h"

namespace noonmark {
namespace {

using namespace tests;

constexpr double degree = std::numbers::pi / 180;
// Points lie this much off their surface, so that altitudes of walls metres away differ by some 0.01 degrees.
constexpr double liftM = SurfaceRays::liftM;

Skyline skylineOf(const City& city, const SkyPoint& point) {
    return Skyline::at(point, collectSkyObstacles(city));
}

// A wall that runs very far to both sides, `distanceM` east of the origin, whose top is seen at `altitudeDeg`
// from 1 m above the ground.
City farWall(double distanceM, double altitudeDeg) {
    return cityOf(
        {{{distanceM, -2e5, 0}, {distanceM + 5, 2e5, 1 + distanceM * std::tan(altitudeDeg * degree)}}});
}

TEST(Skyline, AWallIsSeenAtItsAltitude) {
    const City city = cityOf({{{20, -10, 0}, {30, 10, 21}}});
    const Skyline skyline = skylineOf(city, {{0, 0, 1}, {1, 0, 0}});
    const double away = 20 - liftM;
    EXPECT_NEAR(skyline.tanAt(90 * degree), 20 / away, 1e-3);
    EXPECT_NEAR(skyline.tanAt(70 * degree), 20 / away * std::sin(70 * degree), 1e-3);
    const double corner = std::atan2(away, 10.0);  // of the northern end, from north
    EXPECT_GT(skyline.tanAt(corner + 1e-3), 0.5);
    EXPECT_EQ(skyline.tanAt(corner - 1e-3), 0);
    ASSERT_NE(skyline.pieceAt(90 * degree), nullptr);
    EXPECT_EQ(skyline.pieceAt(90 * degree)->building, 0U);
    EXPECT_EQ(skyline.pieceAt(270 * degree), nullptr);
}

TEST(Skyline, TheHigherOfTwoEdgesHidesUpToTheirCrossing) {
    // Two prisms behind one another, seen across north: 10 m away and 5 m high, 30 m away and 30 m high.
    const City city = cityOf({{{-40, 10, 0}, {40, 12, 5}}, {{-5, 30, 0}, {5, 35, 30}}});
    const Skyline skyline = skylineOf(city, {{0, 0, 0}, {0, 0, 1}});
    EXPECT_EQ(skyline.pieceAt(0.001)->building, 1U);
    EXPECT_EQ(skyline.pieceAt(fullTurn - 0.001)->building, 1U);
    EXPECT_NEAR(skyline.tanAt(0), 1, 2e-3);
    EXPECT_EQ(skyline.pieceAt(20 * degree)->building, 0U);
    EXPECT_NEAR(skyline.tanAt(20 * degree), 0.5 * std::cos(20 * degree), 2e-3);
}

TEST(Skyline, ABalconyHidesAltitudesAndLeavesTheSkyBelowIt) {
    // 3 m above the window, 2 m deep: it hides what is higher than atan(3 / 2) = 56.3 degrees.
    const City city = cityOf({{{-1e4, -10, 0}, {1e4, 0, 20}}, {{-1e4, 0, 5}, {1e4, 2, 5.2}}});
    const Skyline skyline = skylineOf(city, {{0, 0, 2}, {0, 1, 0}});
    const auto hidden = skyline.hiddenAt(0);
    ASSERT_EQ(hidden.size(), 1U);
    EXPECT_NEAR(hidden[0].lowTan, 3 / (2 - liftM), 2e-3);
    EXPECT_FALSE(std::isfinite(hidden[0].highTan));
    EXPECT_FALSE(skyline.hides(towardsSun(0, 55)));
    EXPECT_TRUE(skyline.hides(towardsSun(0, 57)));
    EXPECT_TRUE(skyline.hides(towardsSun(180, 20)));  // behind the window's plane
}

TEST(Skyline, AnOverhangBehindAWallIsLeftOut) {
    // A bridge from 20 to 22 m, 100 m away, behind a wall of 60 m, or of 5 m, at 30 m.
    const Box3 bridge{{-5, 100, 20}, {5, 104, 22}};
    const auto seen = [&](double wallM) {
        const City city = cityOf({{{-200, 30, 0}, {200, 32, wallM}}, bridge});
        return skylineOf(city, {{0, 0, 0}, {0, 0, 1}});
    };
    EXPECT_TRUE(seen(60).faces().empty());
    const Skyline low = seen(5);
    ASSERT_FALSE(low.faces().empty());
    EXPECT_TRUE(low.hides(towardsSun(0, 12)));     // atan(20 / 100) = 11.3, atan(22 / 100) = 12.4
    EXPECT_FALSE(low.hides(towardsSun(0, 10.5)));  // under it, above the wall's atan(5 / 30) = 9.5
    EXPECT_FALSE(low.hides(towardsSun(0, 13)));
}

// Unobstructed: 1 and 100 % lying level; 0.5 and 39.62 % upright. The last is (pi / 4 + 2 / 3) 2 / 3 / (7 pi
// / 9).
TEST(SkyFactors, OfOpenSurfaces) {
    const SkyFactors level = computeSkyFactors(skylineOf({}, {{0, 0, 0}, {0, 0, 1}}));
    EXPECT_NEAR(level.skyView, 1, 1e-9);
    EXPECT_NEAR(level.skyComponentPct, 100, 1e-7);
    const SkyFactors wall = computeSkyFactors(skylineOf({}, {{0, 0, 5}, {0.6F, 0.8F, 0}}));
    EXPECT_NEAR(wall.skyView, 0.5, 1e-6);
    EXPECT_NEAR(wall.skyComponentPct, 39.6187, 1e-3);
    EXPECT_NEAR(computeSkyFactors(skylineOf({}, {{0, 0, 5}, {0, 0, -1}})).skyView, 0, 1e-9);
}

// The vertical sky component of a wall that faces an endless obstruction, as a plain sum over the sky.
double sumVerticalSkyPct(double altitudeDeg) {
    constexpr int parts = 500;
    double sum = 0;
    for (int i = 0; i < parts; ++i) {
        const double aside = ((i + 0.5) / parts - 0.5) * std::numbers::pi;
        const double lowest = std::atan(std::tan(altitudeDeg * degree) * std::cos(aside));
        const double width = (std::numbers::pi / 2 - lowest) / parts;
        for (int k = 0; k < parts; ++k) {
            const double altitude = lowest + (k + 0.5) * width;
            sum += (1 + 2 * std::sin(altitude)) / 3 * std::cos(altitude) * std::cos(altitude) *
                   std::cos(aside) * width * std::numbers::pi / parts;
        }
    }
    return 100 * sum / (7 * std::numbers::pi / 9);
}

// The view factor of the strip of sky above an endless obstruction is (1 - sin a) / 2. BRE 209 states a
// vertical sky component of 27 % for 25 degrees, in whole percent.
TEST(SkyFactors, OfAWallThatFacesAnEndlessObstruction) {
    for (const double altitude : {10.0, 25.0, 45.0, 60.0}) {
        const SkyFactors factors =
            computeSkyFactors(skylineOf(farWall(1000, altitude), {{0, 0, 1}, {1, 0, 0}}));
        EXPECT_NEAR(factors.skyView, (1 - std::sin(altitude * degree)) / 2, 2e-5) << altitude;
        EXPECT_NEAR(factors.skyComponentPct, sumVerticalSkyPct(altitude), 2e-3) << altitude;
        if (altitude == 25) {
            EXPECT_EQ(std::round(factors.skyComponentPct), 27);
        }
    }
}

// In the middle of a round court whose walls are seen at altitude h: cos(h)^2, and under the overcast sky
// (3 (1 - s^2) + 4 (1 - s^3)) / 7 with s = sin h.
TEST(SkyFactors, OfTheMiddleOfARoundCourt) {
    constexpr int sides = 720;
    Ring inner, outer;
    for (int i = 0; i < sides; ++i) {
        const double angle = i * 2 * std::numbers::pi / sides;
        outer.emplace_back(float(40 * std::cos(angle)), float(40 * std::sin(angle)));
        inner.emplace_back(float(20 * std::cos(-angle)), float(20 * std::sin(-angle)));
    }
    City city;
    city.buildings.push_back(buildingOf(Footprint{outer, {inner}}, 0, 20));  // 45 degrees
    const SkyFactors factors = computeSkyFactors(skylineOf(city, {{0, 0, 0}, {0, 0, 1}}));
    const double s = std::sin(45 * degree);
    EXPECT_NEAR(factors.skyView, 0.5, 5e-4);  // the point is 11 mm above the ground
    EXPECT_NEAR(factors.skyComponentPct, 100 * (3 * (1 - s * s) + 4 * (1 - s * s * s)) / 7, 0.05);
}

// Below an endless balcony the sky is seen from the ground up to b = atan(3 / 2): a strip of sin(b) / 2.
TEST(SkyFactors, OfAWindowUnderABalcony) {
    const City city = cityOf({{{-1e4, 0, 5}, {1e4, 2 + liftM, 5.2}}});
    const SkyFactors factors = computeSkyFactors(skylineOf(city, {{0, 0, 2}, {0, 1, 0}}));
    EXPECT_NEAR(factors.skyView, std::sin(std::atan2(3, 2)) / 2, 3e-4);
}

bool isInside(const std::vector<Box3>& boxes, glm::dvec3 place) {
    return std::ranges::any_of(boxes, [&](const Box3& box) {
        return place.x > box.low.x && place.x < box.high.x && place.y > box.low.y && place.y < box.high.y &&
               place.z < box.high.z && place.z > box.low.z;
    });
}

// Points on the walls and roofs of random boxes, some of them raised; none inside a neighbour.
std::vector<SkyPoint> pointsOnWalls(const std::vector<Box3>& boxes) {
    std::vector<SkyPoint> points;
    const auto add = [&](glm::vec3 place, glm::vec3 normal) {
        if (!isInside(boxes, glm::dvec3(place + 0.02F * normal))) points.push_back({place, normal});
    };
    for (const Box3& box : boxes) {
        const glm::vec3 middle((box.low + box.high) / 2.0), half((box.high - box.low) / 2.0);
        for (const float height : {-0.6F, 0.3F}) {
            const glm::vec3 at = middle + glm::vec3(0, 0, height * half.z);
            add(at + glm::vec3(half.x, 0, 0), {1, 0, 0});
            add(at - glm::vec3(half.x, 0, 0), {-1, 0, 0});
            add(at + glm::vec3(0, half.y, 0), {0, 1, 0});
            add(at - glm::vec3(0, half.y, 0), {0, -1, 0});
        }
        add(middle + glm::vec3(0, 0, half.z), {0, 0, 1});
    }
    return points;
}

TEST(SurfaceSkyline, AgreesWithRaysOnRandomScenes) {
    for (const std::uint32_t seed : {1U, 2U, 3U}) {
        const std::vector<Box3> boxes = randomBoxes(seed, 6);
        const City city = cityOf(boxes);
        const SkyObstacles obstacles = collectSkyObstacles(city);
        const RayScene scene = RayScene::over(city).value();
        const SunSteps sun = days(40.7, 30, 4);
        std::size_t different = 0, all = 0;
        for (const SkyPoint& point : pointsOnWalls(boxes)) {
            const ShadedSteps exact = findShadedSteps(Skyline::at(point, obstacles), sun);
            const ShadedSteps truth = traceShadedSteps(scene, point, sun);
            for (std::size_t i = 0; i < exact.size(); ++i) different += exact[i] != truth[i] ? 1 : 0;
            all += exact.size();
        }
        EXPECT_LT(double(different), 2e-5 * double(all))
            << "seed " << seed << ", " << different << " of " << all;
    }
}

TEST(SurfaceSkyline, IsTheSameFromTrees) {
    for (const std::uint32_t seed : {1U, 2U, 3U}) {
        const std::vector<Box3> boxes = randomBoxes(seed, 12);
        const SkyTrees trees(collectSkyObstacles(cityOf(boxes)));
        for (const SkyPoint& point : pointsOnWalls(boxes)) {
            const Skyline all = Skyline::at(point, trees.obstacles), some = Skyline::at(point, trees);
            for (int i = 0; i < 180; ++i) {
                const double azimuth = (i + 0.37) * fullTurn / 180;
                ASSERT_NEAR(some.tanAt(azimuth), all.tanAt(azimuth), 1e-12 * (1 + all.tanAt(azimuth)));
            }
            EXPECT_NEAR(computeSkyFactors(some).skyComponentPct, computeSkyFactors(all).skyComponentPct,
                        1e-6);
        }
    }
}

TEST(SurfaceSkyline, TracedStepsAreThoseOfSurfaceRays) {
    const std::vector<Box3> boxes = randomBoxes(5, 4);
    const City city = cityOf(boxes);
    const RayScene scene = RayScene::over(city).value();
    const SunSteps sun = days(52, 60, 5);
    SurfacePoints points;
    for (const SkyPoint& point : pointsOnWalls(boxes)) {
        points.positions.push_back(point.position);
        points.normals.push_back(point.normal);
    }
    NoProgress progress;
    const SurfaceShadow shadow = SurfaceRays(scene).accumulate(city, points, sun, progress, {}).value();
    for (std::size_t i = 0; i < points.size(); ++i) {
        const PointShadow counted =
            countShadow(traceShadedSteps(scene, {points.positions[i], points.normals[i]}, sun), sun);
        EXPECT_FLOAT_EQ(float(counted.grossMin), shadow.grossMin[i]);
        EXPECT_FLOAT_EQ(float(counted.continuousMin), shadow.continuousMin[i]);
    }
}

TEST(PointSunlight, BandsBreakAtShadowAndAtMissingSlots) {
    SunSteps sun = oneDay({{90, 10}, {100, 20}, {110, 30}, {120, 40}, {130, 50}}, 10);
    for (std::size_t i = 0; i < 5; ++i) sun.steps[i].at = Instant(std::chrono::minutes(10 * i));
    sun.steps[4].slot = 7;
    sun.steps[4].at = Instant(std::chrono::minutes(70));
    const auto at = [](int minutes) { return Instant(std::chrono::minutes(minutes)); };
    const std::vector<SunBand> bands = findSunBands({0, 1, 0, 0, 0}, sun, 0);
    EXPECT_EQ(bands, (std::vector<SunBand>{{at(0), at(10)}, {at(20), at(40)}, {at(70), at(80)}}));
    const PointShadow shadow = countShadow({1, 1, 0, 1, 1}, sun);
    EXPECT_EQ(shadow.grossMin, 40);
    EXPECT_EQ(shadow.continuousMin, 20);
}

TEST(PointSunlight, EndsOfBandsAreRefinedWithinTheirStep) {
    const auto at = [](double minutes) {
        return Instant(std::chrono::milliseconds(std::llround(minutes * 60000)));
    };
    const auto isLit = [&](Instant when) {
        return (when >= at(21.3) && when < at(47.8)) || (when >= at(61.02) && when < at(95));
    };
    // Steps of 15 min: lit at 30 and 45; at 75 and 90, with which the hours end.
    std::vector<SunBand> bands{{at(30), at(60)}, {at(75), at(90)}};
    refineSunBands(bands, 15, isLit);
    const double exactMin = 0.2 / 60;
    EXPECT_NEAR(bands[0].minutes(), 47.8 - 21.3, 2 * exactMin);
    EXPECT_NEAR(SunBand({at(0), bands[0].from}).minutes(), 21.3, exactMin);
    EXPECT_NEAR(SunBand({at(0), bands[1].from}).minutes(), 61.02, exactMin);
    EXPECT_EQ(bands[1].to, at(90));  // still lit there: the end of the hours, not of the sun
}

}  // namespace
}  // namespace noonmark
