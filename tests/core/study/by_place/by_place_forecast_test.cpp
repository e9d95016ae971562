#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <tuple>

#include "core/city/city_position.h"
#include "core/engines/horizon/geometry/azimuth_bins.h"
#include "core/engines/horizon/horizon_sweep.h"
#include "core/study/by_place/group_measure.h"
#include "tests/core/engines/scenes.h"

namespace noonmark {
namespace {

using namespace tests;

SunSteps daysOfSun(int days, double stepMinutes) {
    const Period period{.start = std::chrono::year(2026) / 1 / 1,
                        .days = days,
                        .stepMinutes = stepMinutes,
                        .window = SolarHours{},
                        .zone = "America/New_York"};
    return computeDaylightSteps(period, placeObserver(City{.frame = Frame({-73.98, 40.75})}, {}), {}).value();
}

/// The seconds of the model, of sweeps and of rays, and the work that a run does.
struct Work {
    double sweepSeconds, cellBins;  ///< each receiver at each azimuth bin
    double raySeconds, rays;        ///< each sampled receiver at each step
};

Work workOf(int days, double stepMinutes, float sideM, std::size_t sample) {
    std::vector<Box3> boxes = randomBoxes(3, 10);
    for (Box3& box : boxes) box.low.z = 0;  // overhangs are work of another kind
    City city = cityOf(boxes);
    city.frame = Frame({-73.98, 40.75});
    const Receivers receivers = receiversOver(city, -20, -20, sideM, sideM, 1);
    const SunSteps sun = daysOfSun(days, stepMinutes);
    const StepSets months = monthsOf(sun);
    const HorizonSweep engine;
    const City* const cities[]{&city};
    CitySweeps sweeps(engine, cities, receivers, sun, months);
    const double sweep = sweeps.forecast("horizon", 0), all = sweeps.forecast("horizon", sample);
    return {sweep, double(receivers.cells.size()) * double(binSun(sun, HorizonSweepSettings()).bins.size()),
            all - sweep, double(std::min(sample, receivers.cells.size())) * double(sun.steps.size())};
}

// A day to a year, 10 to 200 thousand receivers, steps of 1 to 30 minutes: seconds for each unit of work
// differ by less than a factor of two, so what holds of one run, holds of the others. The sweep does not
// depend on the step.
TEST(ByPlaceForecast, GrowsAsTheCountedWork) {
    constexpr double infinite = std::numeric_limits<double>::infinity();
    double minimum = infinite, maximum = 0, leastOfRay = infinite, mostOfRay = 0;
    for (const auto& [days, step, side] :
         {std::tuple{30, 10.0, 100.0F}, {365, 30.0, 100.0F}, {365, 10.0, 400.0F}, {90, 1.0, 200.0F}}) {
        const Work work = workOf(days, step, side, 200);
        minimum = std::min(minimum, work.sweepSeconds / work.cellBins);
        maximum = std::max(maximum, work.sweepSeconds / work.cellBins);
        leastOfRay = std::min(leastOfRay, work.raySeconds / work.rays);
        mostOfRay = std::max(mostOfRay, work.raySeconds / work.rays);
    }
    EXPECT_LT(maximum, 2 * minimum);
    EXPECT_NEAR(mostOfRay / leastOfRay, 1, 1e-6);
}

}  // namespace
}  // namespace noonmark
