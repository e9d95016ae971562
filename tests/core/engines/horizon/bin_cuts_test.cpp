#include "core/engines/horizon/geometry/azimuth_bins.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "core/samples/sample_city.h"
#include "core/sun/sun_steps.h"
#include "tests/core/engines/scenes.h"

namespace noonmark::tests {
namespace {

SunSteps sunOf(int month, int days, double hours = 8) {
    Period period;
    period.start = {std::chrono::year{2026}, std::chrono::month(unsigned(month)), std::chrono::day{21}};
    period.days = days;
    period.from = std::chrono::hours(8);
    period.hours = hours;
    period.stepMinutes = days > 30 ? 12 : 1;
    period.zone = "America/New_York";
    return computeSunSteps(period, {{-73.98, 40.75}}).value();
}

double meanErrorPercent(const City& city, const Receivers& receivers, const SunSteps& sun,
                        double targetPercent) {
    NoProgress progress;
    const ShadowField field = HorizonSweep({.errorTargetPercent = targetPercent})
                                  .accumulate(city, receivers, sun, progress, {})
                                  .value();
    const ShadowField truth = traced(city, receivers, sun);
    double sum = 0;
    for (const std::uint32_t cell : receivers.cells)
        sum += std::abs(double(field.grossMin[cell] - truth.grossMin[cell]));
    return 100 * sum / double(receivers.cells.size()) / truth.sunlitMinutesPerDay;
}

// Tests the error target against rays, for days, a month and days of a year, in a city of houses wall to wall
// and in a city of towers.
TEST(BinCuts, TheMeanErrorStaysWithinTheTarget) {
    std::vector<Box3> boxes = randomBoxes(11, 7);
    for (Box3& box : boxes) box.low.z = 0;
    const City houses = cityOf(boxes), towers = makeGridSample({.buildings = 200}).value();
    const glm::vec2 middle = (bounds(towers).low + bounds(towers).high) * 0.5F;
    const Receivers among = receiversOver(houses, -20.3F, -20.3F, 150.7F, 150.7F, 3),
                    below = receiversOver(towers, middle.x - 100, middle.y - 100, middle.x + 100,
                                          middle.y + 100, 5);
    for (const SunSteps& sun : {sunOf(3, 1), sunOf(12, 1), sunOf(9, 7), sunOf(1, 365)})
        for (const double target : {0.05, 0.2}) {
            EXPECT_LE(meanErrorPercent(houses, among, sun, target), target) << sun.dayCount();
            EXPECT_LE(meanErrorPercent(towers, below, sun, target), target) << sun.dayCount();
        }
}

TEST(BinCuts, FewBinsWhereTheTargetAllowsAndManyWhereItAsks) {
    const SunSteps day = sunOf(3, 1), year = sunOf(1, 365);
    for (const SunSteps* sun : {&day, &year}) {
        std::size_t before = 0;
        for (const double target : {1.0, 0.2, 0.05, 0.01}) {
            const BinCuts cuts = chooseBinCuts(*sun, target);
            EXPECT_GT(cuts.bins, before) << target;
            before = cuts.bins;
        }
    }
    EXPECT_LE(chooseBinCuts(year, 0.05).widestDeg, 0.5) << "for the longest runs";
    EXPECT_GT(chooseBinCuts(year, 0.2).widestDeg, 0.5);
    SunSteps minutes = year;
    minutes.stepMinutes = 1;
    EXPECT_LE(chooseBinCuts(minutes, 0.05).widestDeg, 0.25);
    EXPECT_EQ(chooseBinCuts(day, 0.005).bins, day.steps.size());  // one bin for each sun
}

// Some of the suns move ten times as fast in azimuth: bins are narrower where suns are dense.
TEST(BinCuts, BinsAreNarrowWhereTheSunSpendsItsTime) {
    std::vector<Sun> suns;
    for (int i = 0; i < 2000; ++i) suns.push_back({100 + 0.02 * i, 30});
    for (int i = 0; i < 200; ++i) suns.push_back({140 + 0.2 * i, 30});
    const SunSteps sun = oneDay(suns);
    const BinCuts cuts = chooseBinCuts(sun, 0.5);
    const auto binsIn = [&](double from, double to) {
        return cuts.binOfSlot[std::size_t(findAzimuthSlot(to))] -
               cuts.binOfSlot[std::size_t(findAzimuthSlot(from))];
    };
    EXPECT_GT(binsIn(100, 139), 2 * binsIn(141, 179));
    EXPECT_LT(cuts.narrowestDeg * 2, cuts.widestDeg);
    EXPECT_LE(cuts.widestDeg, 2);
}

TEST(BinCuts, EverySunIsInTheBinOfItsAzimuth) {
    const SunSteps sun = sunOf(6, 3, 24);
    const BinCuts cuts = chooseBinCuts(sun, 0.1);
    const BinnedSun binned = binSun(sun, cuts);
    ASSERT_EQ(binned.bins.size(), cuts.bins);
    EXPECT_EQ(binned.bins.size(), binCount(sun, {.errorTargetPercent = 0.1}));
    for (std::size_t i = 0; i < sun.steps.size(); ++i) {
        const std::uint16_t bin =
            cuts.binOfSlot[std::size_t(findAzimuthSlot(computeAzimuthDeg(sun.steps[i])))];
        ASSERT_EQ(binned.places[i].bin, bin);
        const glm::dvec2 towards(sun.steps[i].direction);
        ASSERT_GT(glm::dot(-towards / std::hypot(towards.x, towards.y), binned.bins[bin].away),
                  std::cos(2 * 3.15 / 180));
    }
}

TEST(BinCuts, NoSunNeedsNoBin) {
    SunSteps night;
    night.days.push_back({});
    EXPECT_EQ(chooseBinCuts(night, 0.05).bins, 0U);
}

TEST(BinCuts, WidthsAreStatedInWords) {
    const SunSteps sun = sunOf(3, 1);
    EXPECT_EQ(formatText(binSun(sun, {.binDeg = 0.5})).substr(4), "azimuth bins of 0.5 deg");
    EXPECT_NE(formatText(binSun(sun, {.errorTargetPercent = 0.1})).find(" to "), std::string::npos);
}

}  // namespace
}  // namespace noonmark::tests
