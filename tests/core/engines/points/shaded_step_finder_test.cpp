#include "core/engines/points/point_sunlight.h"

#include <gtest/gtest.h>

#include "tests/core/engines/scenes.h"

namespace noonmark {
namespace {

using namespace tests;
using By = ShadedStepFinder::By;

// On the walls of each box, at three heights.
std::vector<SkyPoint> pointsOnBoxes(const std::vector<Box3>& boxes) {
    std::vector<SkyPoint> points;
    for (const Box3& box : boxes)
        for (const double share : {0.1, 0.5, 0.9}) {
            const double z = box.low.z + share * (box.high.z - box.low.z);
            points.push_back({{(box.low.x + box.high.x) / 2, box.low.y, z}, {0, -1, 0}});
            points.push_back({{box.low.x, (box.low.y + box.high.y) / 2, z}, {-1, 0, 0}});
        }
    return points;
}

SunSteps datedDays(double latitudeDeg, int every, int stepMinutes) {
    SunSteps sun = days(latitudeDeg, every, stepMinutes);
    for (std::size_t day = 0; day < sun.days.size(); ++day)
        sun.days[day].date = std::chrono::sys_days(std::chrono::year(2026) / 1 / 1) +
                             std::chrono::days(std::int64_t(day) * every);
    return sun;
}

TEST(ShadedSteps, ByHorizonsWithCorrectedEndsAreThoseOfRays) {
    std::size_t steps = 0, differ = 0;
    for (const std::uint32_t seed : {21U, 22U, 23U}) {
        const std::vector<Box3> boxes = randomBoxes(seed, 6);
        const City city = cityOf(boxes);
        const SunSteps sun = datedDays(40.7, 6, 1);
        const auto horizons = ShadedStepFinder::over(city, sun, By::horizons).value();
        const auto rays = ShadedStepFinder::over(city, sun, By::rays).value();
        for (const SkyPoint& point : pointsOnBoxes(boxes)) {
            const ShadedSteps found = horizons.find(point), truth = rays.find(point);
            ASSERT_EQ(found.size(), truth.size());
            steps += found.size();
            for (std::size_t i = 0; i < found.size(); ++i) differ += found[i] != truth[i] ? 1 : 0;
        }
    }
    // The sweep alone errs in 1e-3 of the steps.
    EXPECT_LT(double(differ), 5e-5 * double(steps)) << differ << " of " << steps;
}

TEST(ShadedSteps, OfAnOpenWallAreTheSunsBehindIt) {
    const SunSteps sun = datedDays(52, 4, 10);
    const auto finder = ShadedStepFinder::over({}, sun, By::horizons).value();
    const ShadedSteps shaded = finder.find({{0, 0, 5}, {0, -1, 0}});
    for (std::size_t i = 0; i < shaded.size(); ++i)
        EXPECT_EQ(shaded[i] != 0, sun.steps[i].direction.y >= 0) << i;
}

}  // namespace
}  // namespace noonmark
