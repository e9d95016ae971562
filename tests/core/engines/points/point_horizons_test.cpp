#include "core/engines/points/point_horizons.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/engines/points/horizons/horizon_of_point.h"
#include "core/engines/points/point_sunlight.h"
#include "tests/core/engines/blocks_in_rows.h"
#include "tests/core/engines/scenes.h"

namespace noonmark {
namespace {

using namespace tests;

PointMonths sweptAt(const City& city, const SurfacePoints& points, const SunSteps& sun) {
    NoProgress progress;
    return sweepPoints(city, points, sun, progress, {}).value();
}

// Points on walls and roofs of the boxes, some of them sloping; none inside a neighbour.
SurfacePoints onWallsOf(const std::vector<Box3>& boxes) {
    SurfacePoints points;
    const auto inside = [&](glm::dvec3 place) {
        return std::ranges::any_of(boxes, [&](const Box3& box) {
            return place.x > box.low.x && place.x < box.high.x && place.y > box.low.y &&
                   place.y < box.high.y && place.z > box.low.z && place.z < box.high.z;
        });
    };
    const auto add = [&](glm::vec3 place, glm::vec3 normal) {
        if (inside(glm::dvec3(place + 0.02F * normal))) return;
        points.positions.push_back(place);
        points.normals.push_back(normal);
    };
    for (const Box3& box : boxes) {
        const glm::vec3 middle((box.low + box.high) / 2.0), half((box.high - box.low) / 2.0);
        for (const float height : {-0.7F, 0.0F, 0.7F}) {
            const glm::vec3 at = middle + glm::vec3(0, 0, height * half.z);
            add(at + glm::vec3(half.x, 0, 0), {1, 0, 0});
            add(at - glm::vec3(half.x, 0, 0), {-1, 0, 0});
            add(at + glm::vec3(0, half.y, 0), {0, 1, 0});
            add(at - glm::vec3(0, half.y, 0), {0, -1, 0});
        }
        add(middle + glm::vec3(0, 0, half.z), {0, 0, 1});
        add(middle + glm::vec3(0, 0, half.z), {0, -0.6F, 0.8F});
        add(middle + glm::vec3(half.x, 0, 0), {0.8F, 0, -0.6F});
    }
    return points;
}

void setMonths(SunSteps& sun) {
    for (std::size_t day = 0; day < sun.days.size(); ++day)
        sun.days[day].date = std::chrono::sys_days(std::chrono::year(2026) / 1 / 1) +
                             std::chrono::days(day * 365 / sun.days.size());
}

TEST(SurfaceHorizons, AgreeWithRaysOverAYear) {
    for (const std::uint32_t seed : {11U, 12U}) {
        const std::vector<Box3> boxes = randomBoxes(seed, 6);
        const City city = cityOf(boxes);
        SunSteps sun = days(40.7, 5, 1);
        setMonths(sun);
        const SurfacePoints points = onWallsOf(boxes);
        const RayScene scene = RayScene::over(city).value();
        const PointMonths swept = sweptAt(city, points, sun);
        double sum = 0, maximum = 0;
        for (std::size_t i = 0; i < points.size(); ++i) {
            const ShadedSteps truth = traceShadedSteps(scene, {points.positions[i], points.normals[i]}, sun);
            const double lit = double(std::ranges::count(truth, 0)) * sun.stepMinutes;
            const double share = std::abs(swept.sunlitOf(i) - lit) / swept.possibleMin;
            sum += share, maximum = std::max(maximum, share);
        }
        EXPECT_LT(sum / double(points.size()), 1e-3) << "seed " << seed;
        EXPECT_LT(maximum, 5e-3) << "seed " << seed;
        RecordProperty("mean_error_ppm", int(1e6 * sum / double(points.size())));
        RecordProperty("largest_error_ppm", int(1e6 * maximum));
    }
}

// By horizons alone, single points were off by hours: a glimpse of sun between two blocks joins two shadows,
// a narrow tower parts the sun.
TEST(SurfaceHorizons, LongestTimesAreRightWithinTwoSteps) {
    for (const std::uint32_t seed : {2U, 3U}) {
        const std::vector<Box3> boxes = rowsOfBlocks(seed);
        const City city = cityOf(boxes);
        SunSteps sun = days(40.7, 60, 1);
        setMonths(sun);
        const SurfacePoints points = onWallsOf(boxes);
        NoProgress progress;
        const PointMonths swept = sweepPoints(city, points, sun, progress, {}, {.runs = true}).value(),
                          truth = tracePoints(city, points, sun, progress, {}).value();
        double shadow = 0, lit = 0;
        for (std::size_t i = 0; i < points.size(); ++i) {
            const auto off = [i](const std::vector<float>& a, const std::vector<float>& b) {
                return std::abs(double(a[i] - b[i]));
            };
            shadow = std::max(shadow, off(swept.longestShadowMin, truth.longestShadowMin));
            lit = std::max(lit, off(swept.longestSunMin, truth.longestSunMin));
        }
        EXPECT_LE(shadow, 2.01) << seed;
        EXPECT_LE(lit, 2.01) << seed;
    }
}

// What no azimuth of a bin hides is lit, and what every azimuth hides is dark, whatever lies between the
// middles of bins.
TEST(SurfaceHorizons, BoundsHoldAtEveryStep) {
    const std::vector<Box3> boxes = rowsOfBlocks(2);
    const City city = cityOf(boxes);
    SunSteps sun = days(40.7, 12, 1);
    setMonths(sun);
    const SurfacePoints points = onWallsOf(boxes);
    const RayScene rays = RayScene::over(city).value();
    const HorizonScene scene(city, sun, false);
    HorizonOfPoint horizon(scene);
    std::size_t wrong = 0, inDoubt = 0, steps = 0;
    for (std::size_t i = 0; i < points.size(); i += 8) {
        horizon.sweepWithBounds(points.positions[i], points.normals[i], {});
        const ShadedSteps shaded = traceShadedSteps(rays, {points.positions[i], points.normals[i]}, sun);
        for (std::size_t step = 0; step < shaded.size(); ++step) {
            const SunInBin at = binSun(sun.steps[step]);
            const bool covered = horizon.bounds().cover.hides(at), touched = horizon.bounds().touch.hides(at);
            wrong += shaded[step] != 0 ? !touched : covered;
            inDoubt += touched && !covered;
        }
        steps += shaded.size();
    }
    EXPECT_EQ(wrong, 0U);
    EXPECT_GT(inDoubt, 0U);
    EXPECT_LT(inDoubt, steps / 20);
}

TEST(SurfaceHorizons, MonthsAddUpToTheOpenSky) {
    SunSteps sun = days(52, 10, 5);
    setMonths(sun);
    const PointMonths swept = sweptAt({}, {{{0, 0, 0}, {0, 0, 5}}, {{0, 0, 1}, {0, 1, 0}}, {}}, sun);
    std::array<float, 12> months{};
    double northern = 0;
    for (const SunDay& day : sun.days)
        for (std::uint32_t i = day.first; i < day.first + day.count; ++i) {
            months[unsigned(day.date.month()) - 1] += float(sun.stepMinutes);
            northern += sun.steps[i].direction.y > 0 ? sun.stepMinutes : 0;
        }
    EXPECT_EQ(swept.sunlitMin[0], months);
    EXPECT_NEAR(swept.sunlitOf(1), northern, 0.002 * swept.possibleMin);
}

TEST(SurfaceHorizons, RefusePointsWithoutNormals) {
    NoProgress progress;
    EXPECT_FALSE(sweepPoints({}, {{{0, 0, 0}}, {}, {}}, oneDay({{90, 20}}), progress, {}));
}

}  // namespace
}  // namespace noonmark
