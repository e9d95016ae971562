#include "core/engines/projected/projected_shadows.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/core/engines/scenes.h"

namespace noonmark {
namespace {

using namespace tests;

ShadowField projected(const City& city, const Receivers& receivers, const SunSteps& sun) {
    NoProgress progress;
    return ProjectedShadows().accumulate(city, receivers, sun, progress, {}).value();
}

// Two days; hours of 15 steps that repeat every day.
SunSteps twoDays() {
    SunSteps sun;
    addDay(sun, arc(50, 45));
    addDay(sun, arc(61, 30));
    return sun;
}
StepSets hours(const SunSteps& sun) {
    StepSets sets{{"first", "second", "third", "never", "rest"}, {}};
    for (const SunDay& day : sun.days)
        for (std::uint32_t i = 0; i < day.count; ++i)
            sets.ofStep.push_back(i < 45 ? std::uint16_t(i / 15) : 4);
    return sets;
}

TEST(ProjectedBreakdown, EachSetIsARunOverItsOwnSteps) {
    const City city = cityOf(randomBoxes(5, 5));
    const Receivers receivers = receiversOver(city, -20, -20, 120, 120, 2);
    const SunSteps sun = twoDays();
    const StepSets sets = hours(sun);
    NoProgress progress;
    const ShadowBreakdown made = computeProjectedBreakdown(city, receivers, sun, sets, progress, {}).value();
    ASSERT_EQ(made.minutes.size(), sets.names.size());
    EXPECT_EQ(made.sunlitMinutes, (std::vector<double>{30, 30, 30, 0, 21}));
    for (std::size_t set = 0; set < sets.names.size(); ++set) {
        SunSteps own = sets.stepsOf(set, sun);
        EXPECT_EQ(double(own.steps.size()), made.sunlitMinutes[set]);
        own.days = {{.first = 0, .count = std::uint32_t(own.steps.size())}};
        const ShadowField alone = projected(city, receivers, own);
        const std::vector<float> minutes = spreadOverGrid(made, set);
        for (std::size_t cell = 0; cell < receivers.kind.size(); ++cell)
            ASSERT_TRUE(minutes[cell] == alone.grossMin[cell] ||
                        (std::isnan(minutes[cell]) && std::isnan(alone.grossMin[cell])));
    }
}

TEST(ProjectedBreakdown, SetsAddUpToTheField) {
    const City city = cityOf(randomBoxes(6, 5));
    const Receivers receivers = receiversOver(city, -20, -20, 120, 120, 2);
    const SunSteps sun = twoDays();
    const ShadowField field = projected(city, receivers, sun);
    NoProgress progress;
    const ShadowBreakdown made =
        computeProjectedBreakdown(city, receivers, sun, hours(sun), progress, {}).value();
    for (std::size_t i = 0; i < receivers.cells.size(); ++i) {
        double minutes = 0;
        for (const auto& set : made.minutes) minutes += double(set[i]);
        ASSERT_EQ(float(minutes / 2), field.grossMin[receivers.cells[i]]);
    }
}

TEST(ProjectedBreakdown, RefusesTerrainAndStops) {
    City city = cityOf({{{0, 0, 0}, {10, 10, 10}}});
    const Receivers receivers = receiversOver(city, -20, -20, 20, 20);
    const SunSteps sun = twoDays();
    NoProgress progress;
    std::stop_source source;
    source.request_stop();
    EXPECT_TRUE(isCancelled(
        computeProjectedBreakdown(city, receivers, sun, hours(sun), progress, source.get_token()).error()));
    city.terrain = std::make_shared<const Terrain>(Terrain{{-50, -50, 50, 2, 2}, {0, 1, 2, 3}});
    const auto refused = ProjectedShadows().breakDown(city, receivers, sun, hours(sun), false, progress, {});
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().kind, ErrorKind::unsupported);
}

}  // namespace
}  // namespace noonmark
