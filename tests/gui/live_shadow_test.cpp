#include "app/window/massing/live_shadow.h"

#include <gtest/gtest.h>

#include "core/accumulate/projected_shadows.h"
#include "tests/gui/small_city.h"

namespace noonmark {
namespace {

Period morning(double stepMinutes) {
    Period period;
    period.start = std::chrono::year(2026) / 4 / 20;
    period.from = std::chrono::hours(8);
    period.hours = 3;
    period.stepMinutes = stepMinutes;
    period.zone = "America/New_York";
    return period;
}

const Observer newYork{{-73.98, 40.76}, 0};

std::vector<std::shared_ptr<const Building>> tower() {
    Building building{.sourceId = "Tower 1"};
    building.parts.push_back({.footprint = test::square({20, -30}, 30), .topM = 120});
    return {std::make_shared<const Building>(building)};
}

TEST(LiveShadow, IsThatOfAStudyOfTheCityWithTheTower) {
    NoProgress progress;
    City city = test::smallCity();
    const auto live = LiveShadow::around(city, {0, 0}, 200, morning(2), newYork, progress, {}).value();
    ASSERT_EQ(live->moments(), live->momentsOfPeriod());
    const ShadowField shown = live->with(tower()).value();
    city.buildings.push_back(tower().front());
    const auto sun = sunSteps(morning(2), newYork).value();
    const auto study = ProjectedShadows().accumulate(city, live->receivers(), sun, progress, {}).value();
    double shaded = 0;
    for (const std::uint32_t cell : live->receivers().cells) {
        ASSERT_EQ(shown.grossMin[cell], study.grossMin[cell]);
        ASSERT_EQ(shown.continuousMin[cell], study.continuousMin[cell]);
        shaded += double(study.grossMin[cell]);
    }
    EXPECT_GT(shaded, 10000);
}

TEST(LiveShadow, FollowsAShapeThatMovesAndGoes) {
    NoProgress progress;
    const City city = test::smallCity();
    const auto live = LiveShadow::around(city, {0, 0}, 200, morning(2), newYork, progress, {}).value();
    const ShadowField before = live->with({}).value(), first = live->with(tower()).value();
    Building moved = *tower().front();
    for (glm::vec2& point : moved.parts[0].footprint.outer) point.x += 15;
    const ShadowField second = live->with({std::make_shared<const Building>(moved)}).value();
    const ShadowField again = live->with(tower()).value(), after = live->with({}).value();
    std::size_t different = 0;
    for (const std::uint32_t cell : live->receivers().cells) {
        ASSERT_EQ(again.grossMin[cell], first.grossMin[cell]);
        ASSERT_EQ(after.continuousMin[cell], before.continuousMin[cell]);
        different += std::size_t(second.grossMin[cell] != first.grossMin[cell]);
    }
    EXPECT_GT(different, 500U);
}

TEST(LiveShadow, ALongPeriodIsLookedAtInSomeMomentsAndStaysNear) {
    NoProgress progress;
    const City city = test::smallCity();
    const auto some = LiveShadow::around(city, {0, 0}, 200, morning(0.2), newYork, progress, {}).value();
    EXPECT_EQ(some->moments(), LiveShadow::someMoments);
    EXPECT_EQ(some->momentsOfPeriod(), 900U);
    const auto all = LiveShadow::around(city, {0, 0}, 200, morning(2), newYork, progress, {}).value();
    const ShadowField a = some->with(tower()).value(), b = all->with(tower()).value();
    EXPECT_DOUBLE_EQ(a.sunlitMinutesPerDay, b.sunlitMinutesPerDay);
    double difference = 0;
    for (const std::uint32_t cell : some->receivers().cells)
        difference += std::abs(double(a.grossMin[cell]) - double(b.grossMin[cell]));
    EXPECT_LT(difference / double(some->receivers().cells.size()), 1.5) << "minutes of 180";
}

TEST(LiveShadow, TerrainAndNightAreRefused) {
    NoProgress progress;
    City city = test::smallCity();
    Period night = morning(2);
    night.from = std::chrono::hours(0);
    EXPECT_FALSE(LiveShadow::around(city, {0, 0}, 200, night, newYork, progress, {}));
    city.terrain =
        std::make_shared<const Terrain>(Terrain{{-500, -500, 100, 10, 10}, std::vector<float>(100, 3)});
    EXPECT_FALSE(LiveShadow::around(city, {0, 0}, 200, morning(2), newYork, progress, {}));
}

}  // namespace
}  // namespace noonmark
