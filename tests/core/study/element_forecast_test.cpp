#include "core/study/elements/element_study.h"

#include <gtest/gtest.h>

#include "core/city/trees/tree.h"
#include "tests/core/engines/scenes.h"

namespace noonmark {
namespace {

using namespace tests;

StudySettings fewHours(const City& city) {
    StudySettings settings;
    settings.region = makeRegionFromLocalBox(bounds(city));
    settings.period.start = CivilDate{std::chrono::year(2026), std::chrono::March, std::chrono::day(21)};
    settings.period.hours = 6;
    settings.period.stepMinutes = 10;
    return settings;
}

TEST(ElementForecast, CountsThePointsAndStepsThatTheStudyMeasures) {
    const City city = cityOf(std::vector<Box3>{{{0, 0, 0}, {30, 30, 60}}, {{50, 0, 0}, {70, 30, 20}}});
    NoProgress quiet;
    const StudySettings settings = fewHours(city);
    const auto forecast = forecastElementStudy(city, settings, {}, quiet, {});
    ASSERT_TRUE(forecast) << forecast.error().text();
    const auto study = runElementStudy(city, settings, {}, quiet, {});
    ASSERT_TRUE(study) << study.error().text();
    EXPECT_EQ(forecast->points, study->receivers.size());
    EXPECT_EQ(forecast->steps, study->sun.steps.size());
    EXPECT_GT(forecast->horizonSeconds, 0);
    EXPECT_GT(forecast->raySeconds, 0);
}

TEST(ElementForecast, MeasuresTheTreesThatAreWanted) {
    City city = cityOf(std::vector<Box3>{{{0, 0, 0}, {30, 30, 60}}});
    city.trees = std::make_shared<const Trees>(Trees{{{.place = {36, 15},
                                                       .heightM = 12,
                                                       .crownBaseM = 3,
                                                       .crownDiameterM = 8,
                                                       .leafOnTransmissivity = 0.1F,
                                                       .leafOffTransmissivity = 0.7F}},
                                                     {106, 320}});
    NoProgress quiet;
    StudySettings settings = fewHours(city);
    EXPECT_EQ(forecastElementStudy(city, settings, {}, quiet, {})->trees, 1);
    settings.trees = TreeColumns::without;
    EXPECT_EQ(forecastElementStudy(city, settings, {}, quiet, {})->trees, 0);
}

TEST(ElementForecast, IsRefusedAsTheStudyIs) {
    const City city = cityOf(std::vector<Box3>{{{0, 0, 0}, {30, 30, 60}}});
    NoProgress quiet;
    const auto forecast = forecastElementStudy(city, fewHours(city), {.buildings = {"nowhere"}}, quiet, {});
    ASSERT_FALSE(forecast);
    const auto study = runElementStudy(city, fewHours(city), {.buildings = {"nowhere"}}, quiet, {});
    ASSERT_FALSE(study);
    EXPECT_EQ(forecast.error().text(), study.error().text());
}

}  // namespace
}  // namespace noonmark
