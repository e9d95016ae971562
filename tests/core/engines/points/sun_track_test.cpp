#include "core/engines/points/horizons/sun_track.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <glm/vector_relational.hpp>
#include <vector>

#include "core/engines/points/point_horizons.h"
#include "core/engines/points/point_sunlight.h"
#include "tests/core/engines/points/random_horizon.h"
#include "tests/core/engines/scenes.h"

namespace noonmark {
namespace {

using namespace tests;

TEST(SunTrack, CountsAsStepByStep) {
    SunSteps sun = days(47, 40, 3);
    for (std::size_t i = 700; i < sun.steps.size(); ++i) sun.steps[i].slot += 5;  // a gap within a day
    const SunTrack track(sun);
    for (std::uint32_t seed = 1; seed < 20; ++seed) {
        const BinHorizon horizon = randomHorizon(seed);
        ShadedSteps shaded, lit;
        for (const SunStep& step : sun.steps) {
            shaded.push_back(horizon.hides(binSun(step)) ? 1 : 0);
            lit.push_back(1 - shaded.back());
        }
        const PointRuns runs = track.countRuns(horizon);
        EXPECT_EQ(runs.shadow * sun.stepMinutes, countShadow(shaded, sun).continuousMin) << seed;
        EXPECT_EQ(runs.sun * sun.stepMinutes, countShadow(lit, sun).continuousMin) << seed;
    }
}

// Runs of a day, by steps.
std::vector<TrackRun> runsByStep(const BinHorizon& horizon, const SunSteps& sun, bool ofShadow) {
    std::vector<TrackRun> runs;
    for (const SunDay& day : sun.days)
        for (std::uint32_t i = day.first; i < day.first + day.count; ++i) {
            if (horizon.hides(binSun(sun.steps[i])) != ofShadow) continue;
            const bool goesOn = i > day.first && !runs.empty() && runs.back().end == i &&
                                sun.steps[i].slot == sun.steps[i - 1].slot + 1;
            if (!goesOn) runs.push_back({i, i});
            runs.back().end = i + 1;
        }
    return runs;
}

TEST(SunTrack, FindsAllRunsThatAreLongerThanSomeSteps) {
    SunSteps sun = days(47, 40, 3);
    for (std::size_t i = 700; i < sun.steps.size(); ++i) sun.steps[i].slot += 5;  // a gap within a day
    const SunTrack track(sun);
    for (std::uint32_t seed = 1; seed < 20; ++seed) {
        const BinHorizon horizon = randomHorizon(seed);
        for (const bool ofShadow : {true, false}) {
            std::vector<TrackRun> all = runsByStep(horizon, sun, ofShadow);
            std::ranges::stable_sort(all, std::ranges::greater{}, &TrackRun::length);
            for (const std::uint32_t minimum : {0U, 5U, 31U, 32U, 63U, 64U, 100U}) {
                const std::vector<TrackRun> found = track.findRuns(horizon, ofShadow, minimum);
                const auto end =
                    std::ranges::find_if(all, [&](const TrackRun& run) { return run.length() <= minimum; });
                ASSERT_EQ(found.size(), std::size_t(end - all.begin())) << seed << " " << minimum;
                for (std::size_t i = 0; i < found.size(); ++i) {
                    EXPECT_EQ(found[i].first, all[i].first) << seed << " " << minimum;
                    EXPECT_EQ(found[i].end, all[i].end) << seed << " " << minimum;
                }
            }
        }
    }
}

// On southern and eastern walls, none inside another box.
SurfacePoints pointsAround(const std::vector<Box3>& boxes) {
    SurfacePoints points;
    const auto add = [&](glm::dvec3 place, glm::dvec3 normal) {
        const glm::dvec3 front = place + 0.02 * normal;
        for (const Box3& box : boxes)
            if (glm::all(glm::lessThan(box.low, front)) && glm::all(glm::lessThan(front, box.high))) return;
        points.positions.emplace_back(place);
        points.normals.emplace_back(normal);
    };
    for (const Box3& box : boxes) {
        const glm::dvec3 middle = (box.low + box.high) / 2.0;
        for (const double share : {0.2, 0.5, 0.9}) {
            const double height = box.low.z + share * (box.high.z - box.low.z);
            add({middle.x, box.low.y, height}, {0, -1, 0});
            add({box.high.x, middle.y, height}, {1, 0, 0});
        }
    }
    return points;
}

TEST(TracedPoints, CountWhatTheirStepsSay) {
    const std::vector<Box3> boxes = randomBoxes(3, 5);
    const City city = cityOf(boxes);
    SunSteps sun = days(40.7, 20, 5);
    numberDays(sun);
    const SurfacePoints points = pointsAround(boxes);
    NoProgress quiet;
    const PointMonths traced = tracePoints(city, points, sun, quiet, {}).value();
    const RayScene scene = RayScene::over(city).value();
    float january = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const ShadedSteps shaded = traceShadedSteps(scene, {points.positions[i], points.normals[i]}, sun);
        const PointShadow shadow = countShadow(shaded, sun);
        EXPECT_NEAR(traced.sunlitOf(i), traced.possibleMin - shadow.grossMin * double(sun.dayCount()), 0.01);
        EXPECT_FLOAT_EQ(traced.longestShadowMin[i], float(shadow.continuousMin));
        EXPECT_EQ(traced.sunlitMin[i][5], 0);
        january += traced.sunlitMin[i][0];
    }
    EXPECT_GT(january, 0);
}

// A run ends where the sweep and the rays see an edge, half a minute of time apart at most; where a short
// sun between two runs is seen by one of them alone, runs differ by more.
TEST(SurfaceHorizons, CountUnbrokenTimesNearThoseOfRays) {
    const std::vector<Box3> boxes = randomBoxes(11, 6);
    const City city = cityOf(boxes);
    SunSteps sun = days(40.7, 8, 1);
    numberDays(sun);
    const SurfacePoints points = pointsAround(boxes);
    NoProgress quiet;
    const PointMonths traced = tracePoints(city, points, sun, quiet, {}).value();
    const PointMonths swept = sweepPoints(city, points, sun, quiet, {}, {.runs = true}).value();
    EXPECT_TRUE(sweepPoints(city, points, sun, quiet, {}).value().longestSunMin.empty());
    for (std::size_t i = 0; i < points.size(); ++i) {
        EXPECT_NEAR(swept.longestShadowMin[i], traced.longestShadowMin[i], 3) << i;
        EXPECT_NEAR(swept.longestSunMin[i], traced.longestSunMin[i], 3) << i;
    }
}

}  // namespace
}  // namespace noonmark
