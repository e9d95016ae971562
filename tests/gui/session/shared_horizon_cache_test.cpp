#include "app/gui/session/study/shared_horizon_cache.h"

#include <gtest/gtest.h>

#include <random>
#include <thread>

#include "tests/gui/live_scene.h"

namespace noonmark {
namespace {

using namespace test;

struct SharedHorizonsTest : ::testing::Test {
    SharedHorizonCache shared;
    NoProgress progress;
    const Region region = makeRegionFromLocalBox({{-120, -120}, {120, 120}});

    [[nodiscard]] Receivers receiversOf(const City& city, double cellM = 3) const {
        return placeReceiversOnGround(city, region, {.cellM = cellM}).value();
    }
    Result<ShadowField> field(const City& city, const Period& period,
                              ShadowCounts counts = ShadowCounts::grossAndRuns,
                              const std::stop_token& stop = {}) {
        return shared.field(city, receiversOf(city), sunOf(period), counts, progress, stop);
    }
    void expectFresh(const Result<ShadowField>& field, const City& city, const Period& period) {
        ASSERT_TRUE(field);
        const ShadowField fresh = freshHorizons(city, receiversOf(city), period);
        EXPECT_TRUE(sameBits(field->grossMin, fresh.grossMin));
        const bool none =
            std::ranges::all_of(field->continuousMin, [](float minutes) { return std::isnan(minutes); });
        EXPECT_TRUE(none || sameBits(field->continuousMin, fresh.continuousMin));
    }
};

TEST_F(SharedHorizonsTest, OneSetAnswersSlidersAndShapesInTurn) {
    std::mt19937 random(3);
    const City cities[] = {smallCity(), with(smallCity(), tower()), with(smallCity(), tower(20)),
                           smallCityOnASlope()};
    const Period periods[] = {spring(1, 5), spring(40, 15), spring(3, 30)};
    for (int round = 0; round < 40; ++round) {
        const City& city = cities[random() % 3];
        const Period& period = periods[random() % 3];
        const auto counts = random() % 3 == 0 ? ShadowCounts::grossAndRuns : ShadowCounts::gross;
        expectFresh(field(city, period, counts), city, period);
    }
    EXPECT_EQ(shared.sets(), 1);
    expectFresh(field(cities[3], periods[0]), cities[3], periods[0]);
    EXPECT_EQ(shared.sets(), 2) << "nothing is reused on another ground";
}

TEST_F(SharedHorizonsTest, AnotherGridIsAnotherSet) {
    const City city = smallCity();
    ASSERT_TRUE(field(city, spring(1, 10)));
    ASSERT_TRUE(
        shared.field(city, receiversOf(city, 4), sunOf(spring(1, 10)), ShadowCounts::gross, progress, {}));
    EXPECT_EQ(shared.sets(), 2);
    shared.forget();
    expectFresh(field(city, spring(1, 10)), city, spring(1, 10));
    EXPECT_EQ(shared.sets(), 3);
}

TEST_F(SharedHorizonsTest, AfterAStopOrAnErrorTheNextAnswerIsWhole) {
    std::stop_source stopped;
    stopped.request_stop();
    const City city = smallCity(), other = with(smallCity(), tower());
    ASSERT_TRUE(field(city, spring(1, 5)));
    EXPECT_TRUE(isCancelled(field(other, spring(1, 5), ShadowCounts::gross, stopped.get_token()).error()));
    expectFresh(field(other, spring(1, 5)), other, spring(1, 5));
    Period night = spring(1, 5);
    night.from = std::chrono::hours(0);
    EXPECT_EQ(field(other, night).error().what, "The sun is below the horizon all the time");
    expectFresh(field(city, spring(1, 5)), city, spring(1, 5));
}

TEST_F(SharedHorizonsTest, WhatIsStoppedAnywhereIsWholeAfterwards) {
    class StopAfter final : public Progress {
    public:
        explicit StopAfter(int reports) : left_(reports) {}
        void report(double, std::string_view) override {
            if (--left_ == 0) source.request_stop();
        }
        std::stop_source source;

    private:
        std::atomic<int> left_;
    };
    const City cities[] = {smallCity(), with(smallCity(), tower())};
    for (int round = 1; round < 12; ++round) {
        StopAfter stopper(5 * round);
        const City &before = cities[round % 2], &after = cities[(round + 1) % 2];
        const Period period = spring(round, 10);
        (void)shared.field(before, receiversOf(before), sunOf(period), ShadowCounts::grossAndRuns, stopper,
                           stopper.source.get_token());
        expectFresh(field(after, period), after, period);
    }
}

TEST_F(SharedHorizonsTest, TwoJobsMayAskAtATime) {
    const City city = smallCity(), other = with(smallCity(), tower());
    Result<ShadowField> first = cancelled();
    {
        const std::jthread beside([&] { first = field(city, spring(2, 5)); });
        expectFresh(field(other, spring(1, 5)), other, spring(1, 5));
    }
    expectFresh(first, city, spring(2, 5));
}

}  // namespace
}  // namespace noonmark
