// The exact engines against the ray reference on every cell of a park, over a year.
#include <gtest/gtest.h>

#include <cmath>

#include "core/samples/sample_city.h"
#include "core/study/study.h"

namespace noonmark {
namespace {

// Every half hour of a year on the southern end of Central Park; some 50 million rays.
StudySettings yearOf(const City& city, const std::string& engine) {
    StudySettings settings;
    settings.region = makeRegionFromLonLatBox(city.frame, -73.9785, 40.7657, -73.9735, 40.7697).value();
    settings.receivers.cellM = 5;
    settings.period = {.start = std::chrono::year(2026) / 1 / 1,
                       .days = 365,
                       .stepMinutes = 30,
                       .window = SolarHours{std::chrono::minutes(90), std::chrono::minutes(90)},
                       .zone = "America/New_York"};
    settings.engine = engine;
    settings.errorSample.receivers = 0;
    return settings;
}

struct Difference {
    double meanPct = 0, maxPct = 0;  // of the minutes of the period
};

Difference compareWithRays(const std::string& engine) {
    static const City city = makeCentralParkSouthSample();
    NoProgress progress;
    static const Study rays = runStudy(city, yearOf(city, "ray"), progress, {}).value();
    const Study study = runStudy(city, yearOf(city, engine), progress, {}).value();
    EXPECT_EQ(study.receivers.cells, rays.receivers.cells);
    EXPECT_GT(rays.receivers.cells.size(), 7000U);
    Difference difference;
    for (const std::uint32_t cell : rays.receivers.cells) {
        const double pct = 100 *
                           std::abs(double(study.field.grossMin[cell]) - double(rays.field.grossMin[cell])) /
                           rays.field.sunlitMinutesPerDay;
        difference.meanPct += pct / double(rays.receivers.cells.size());
        difference.maxPct = std::max(difference.maxPct, pct);
    }
    return difference;
}

// Of 6,730 steps one is 0.015 %.
TEST(ParkAgainstRays, ProjectedShadowsDifferOnSingleStepsOnly) {
    const Difference difference = compareWithRays("projected");
    EXPECT_LT(difference.meanPct, 0.0001);
    EXPECT_LT(difference.maxPct, 0.05);
}

TEST(ParkAgainstRays, TheHorizonSweepKeepsItsErrorOnEveryCell) {
    const Difference difference = compareWithRays("horizon");
    EXPECT_LT(difference.meanPct, 0.1);
    EXPECT_LT(difference.maxPct, 0.6);
}

}  // namespace
}  // namespace noonmark
