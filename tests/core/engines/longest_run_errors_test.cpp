#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "core/engines/horizon/horizon_sweep.h"
#include "core/sun/sun_steps.h"
#include "tests/core/engines/scenes.h"

namespace noonmark {
namespace {

using namespace tests;

/// High blocks in rows, with gaps of 0.3 to 2 m between them, narrower than a bin from most receivers.
City blocksWithNarrowGaps(std::uint32_t seed) {
    std::mt19937 random(seed);
    const auto between = [&](double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random);
    };
    std::vector<Box3> boxes;
    for (double south = 0; south < 160; south += 40)
        for (double west = between(0, 10), east = 0; west < 160; west = east + between(0.3, 2)) {
            east = west + between(8, 25);
            boxes.push_back(
                {glm::dvec3(glm::vec3(glm::dvec3(west, south, 0))),
                 glm::dvec3(glm::vec3(glm::dvec3(east, south + between(6, 15), between(40, 150))))});
        }
    return cityOf(boxes);
}

ShadowField swept(const City& city, const Receivers& receivers, const SunSteps& sun, bool checksRuns) {
    NoProgress progress;
    return HorizonSweep({.checksRuns = checksRuns}).accumulate(city, receivers, sun, progress, {}).value();
}

/// By how much the longest run of each receiver is too long, in percent of the longest day, ascending.
std::vector<double> tooLongPercent(const ShadowField& field, const ShadowField& truth,
                                   const Receivers& receivers, double dayMinutes) {
    std::vector<double> errors;
    for (const std::uint32_t cell : receivers.cells)
        errors.push_back(100 * double(field.continuousMin[cell] - truth.continuousMin[cell]) / dayMinutes);
    std::ranges::sort(errors);
    return errors;
}

double shareFurtherOff(const std::vector<double>& errors, double percent) {
    const auto off = [&](double error) { return std::abs(error) > percent + 1e-4; };
    return double(std::ranges::count_if(errors, off)) / double(errors.size());
}

constexpr double dayMinutes = 480;

SunSteps yearInNewYork(double stepMinutes) {
    Period period;
    period.start = CivilDate(std::chrono::year(2026), std::chrono::January, std::chrono::day(1));
    period.days = 365;
    period.from = std::chrono::hours(8);
    period.hours = dayMinutes / 60;
    period.stepMinutes = stepMinutes;
    period.zone = "America/New_York";
    return computeSunSteps(period, {{-73.98, 40.75}, 0, 1010, 10}).value();
}

// By horizons alone, eight of these 9,410 cells were off by more than one step, up to 19 % of the day.
TEST(LongestRunErrors, AreRareAtStepsOfTenMinutes) {
    const City city = blocksWithNarrowGaps(1);
    const Receivers receivers = receiversOver(city, -20.3F, -20.3F, 180.7F, 200.7F, 2);
    const SunSteps sun = yearInNewYork(10);
    const ShadowField field = swept(city, receivers, sun, false);
    const std::vector<double> errors =
        tooLongPercent(field, traced(city, receivers, sun), receivers, dayMinutes);
    EXPECT_EQ(shareFurtherOff(errors, 100 * 10 / dayMinutes), 0);
    EXPECT_NE(field.engine.find("decided by rays"), std::string::npos) << field.engine;
    EXPECT_GT(field.cost.rays, 0U);
}

// By horizons alone, 0.26 % of these cells were off by more than 2 %, up to 48 % of the day.
TEST(LongestRunErrors, AreSmallWhereRunsAreChecked) {
    const City city = blocksWithNarrowGaps(2);
    const Receivers receivers = receiversOver(city, -20.3F, -20.3F, 180.7F, 200.7F, 4);
    const SunSteps sun = days(40.7, 8, 1);
    const std::vector<double> errors = tooLongPercent(swept(city, receivers, sun, true),
                                                      traced(city, receivers, sun), receivers, dayMinutes);
    EXPECT_EQ(shareFurtherOff(errors, 2), 0);
}

// Rays affect only longest runs.
TEST(LongestRunErrors, GrossShadowIsThatOfHorizons) {
    const City city = blocksWithNarrowGaps(3);
    const Receivers receivers = receiversOver(city, -20.3F, -20.3F, 180.7F, 200.7F, 4);
    const SunSteps sun = days(40.7, 8, 10);
    const ShadowField decided = swept(city, receivers, sun, false),
                      checked = swept(city, receivers, sun, true);
    for (const std::uint32_t cell : receivers.cells)
        EXPECT_EQ(decided.grossMin[cell], checked.grossMin[cell]);
}

}  // namespace
}  // namespace noonmark
