#include <gtest/gtest.h>
#include <algorithm>
#include <chrono>
#include <limits>
#include <set>
#include <thread>

#include "core/engines/ray/ray_reference.h"
#include "core/lab/bench/contests/contest.h"
#include "core/lab/lab_engines.h"
#include "tests/core/lab/bench/tiny_site.h"

namespace noonmark::bench {

namespace {

/// Returns the ray reference's field with minutes added, after a delay; or refuses.
class Made final : public Engine {
public:
    Made(double addedMin, double seconds, bool refuses = false)
        : addedMin_(addedMin), seconds_(seconds), refuses_(refuses) {}

    [[nodiscard]] std::string_view name() const override { return "Made"; }
    [[nodiscard]] EngineCapabilities capabilities() const override { return {}; }

protected:
    Result<ShadowField> compute(const City& city, const Receivers& receivers, const SunSteps& sun,
                                Progress& progress, std::stop_token stop) const override {
        if (refuses_) return failure("Not on such ground");
        for (double waited = 0; waited < seconds_; waited += 0.01) {
            if (stop.stop_requested()) return cancelled();
            std::this_thread::sleep_for(std::chrono::milliseconds(10));
        }
        auto field = RayReference().accumulate(city, receivers, sun, progress, stop);
        for (float& minutes : field->grossMin) minutes += float(addedMin_);
        return field;
    }

private:
    double addedMin_;
    double seconds_;
    bool refuses_;
};

class ContestTest : public testing::Test {
protected:
    Placing placingOf(double addedMin, double seconds, bool refuses = false) {
        const std::vector<Contestant> contestants{
            {"made", "Made", "", std::make_shared<Made>(addedMin, seconds, refuses)}};
        const Truth truth = computeTruth(scene_, receivers_, work_).value();
        return runContest(scene_, contestants, truth, extent_, work_).value().front();
    }

    BenchSite site_ = tests::tinySite();
    Receivers receivers_ = pickMiddleReceivers(site_, {}).value();
    SunSteps sun_ = makeNoonHour(site_).value();
    Scene scene_{site_.city, receivers_, sun_};
    NoProgress silent_;
    Work work_{silent_, {}};
    Extent extent_;
};

TEST_F(ContestTest, TheRightAnswerIsTimedAsOftenAsAsked) {
    const Placing placing = placingOf(0, 0);
    EXPECT_EQ(placing.error, FieldError{});
    EXPECT_EQ(placing.runs, 5);
    EXPECT_GT(placing.medianS, 0);
    EXPECT_TRUE(placing.refusal.empty());
}

TEST_F(ContestTest, ErrorsAreInPercentOfThePeriod) {
    const Placing placing = placingOf(1.2, 0);  // of 60 min
    EXPECT_NEAR(placing.error.areaPct, 2, 1e-4);
    EXPECT_NEAR(placing.error.cellMeanPct, 2, 1e-4);
    EXPECT_NEAR(placing.error.cellMaxPct, 2, 1e-4);
    EXPECT_TRUE(placing.timed());
}

TEST_F(ContestTest, AWrongAnswerIsNotTimed) {
    const Placing placing = placingOf(10, 0);
    EXPECT_FALSE(placing.timed());
    EXPECT_NE(placing.refusal.find("differ by 16.7 %"), std::string::npos) << placing.refusal;
}

TEST_F(ContestTest, ARefusalIsKept) {
    const Placing placing = placingOf(0, 0, true);
    EXPECT_FALSE(placing.timed());
    EXPECT_FALSE(placing.tooSlow);
    EXPECT_EQ(placing.refusal, "Not on such ground");
}

TEST_F(ContestTest, WhoNeverEndsIsStopped) {
    extent_.neverAboveS = 0.05;
    const Placing placing = placingOf(0, 1000);
    EXPECT_TRUE(placing.tooSlow);
    EXPECT_FALSE(placing.timed());
}

TEST(BenchForecast, GivesUpWhatWouldTakeHalfAsLongAgain) {
    EXPECT_TRUE(isHopeless(6, 0.1, 20));
    EXPECT_FALSE(isHopeless(4, 0.1, 20));   // too early to tell
    EXPECT_FALSE(isHopeless(6, 0.25, 20));  // it may end in time
    EXPECT_FALSE(isHopeless(6, 0, 20));     // it reports no progress
    EXPECT_FALSE(isHopeless(1e6, 0.5, std::numeric_limits<double>::infinity()));
}

TEST_F(ContestTest, WhoIsNeededIsLetEnd) {
    extent_.neverAboveS = 0.01;
    const std::vector<Contestant> needed{
        {"made", "Made", "", std::make_shared<Made>(0, 0.05), /*needed=*/true}};
    const Truth truth = computeTruth(scene_, receivers_, work_).value();
    EXPECT_TRUE(runContest(scene_, needed, truth, extent_, work_).value().front().timed());
}

TEST_F(ContestTest, WhoCostsTooMuchIsLeftOutAndKeepsItsPlace) {
    const std::vector<Contestant> three{{"a", "A", "", std::make_shared<Made>(0, 0)},
                                        {"b", "B", "", std::make_shared<Made>(0, 0)},
                                        {"c", "C", "", std::make_shared<Made>(1.2, 0)}};
    const Truth truth = computeTruth(scene_, receivers_, work_).value();
    const auto placings = runContestWithin(3, {1, 10, 2}, scene_, three, truth, extent_, work_).value();
    ASSERT_EQ(placings.size(), 3U);
    EXPECT_TRUE(placings[0].timed());
    EXPECT_TRUE(placings[1].tooSlow);
    EXPECT_FALSE(placings[1].timed());
    EXPECT_NEAR(placings[2].error.areaPct, 2, 1e-4) << "the third one's";
    EXPECT_TRUE(placings[0].peakBytes.has_value());
}

TEST_F(ContestTest, WhatTakesLongIsRunOnce) {
    extent_.onceAboveS = 0.01;
    const Placing placing = placingOf(0, 0.03);
    EXPECT_EQ(placing.runs, 1);
    EXPECT_GE(placing.medianS, 0.03);
}

TEST_F(ContestTest, TheWholeRaysTimeGrowsWithTheReceivers) {
    Truth truth;
    truth.field.cost.seconds = {{"build", 2}, {"trace", 3}};
    truth.receivers = receivers_;
    truth.receivers.cells.resize(receivers_.cells.size() / 4);
    const double share = double(receivers_.cells.size()) / double(truth.receivers.cells.size());
    EXPECT_NEAR(secondsForAll(truth, receivers_), 2 + 3 * share, 1e-9);
}

TEST(BenchContestants, EveryEngineOfTheListRunsWithItsDefaults) {
    const StartList list = listDefaultEngines(coreAndLabEngines());
    EXPECT_EQ(list.contestants.size() + list.absent.size(), coreAndLabEngines().size());
    for (const Contestant& contestant : list.contestants) EXPECT_TRUE(contestant.setting.empty());
}

TEST(BenchContestants, SettingsAreTriedOnceEach) {
    const StartList list = listVariedEngines(coreAndLabEngines(), {0.25, 0.5, 1, 2, 4});
    std::set<std::string> titles;
    for (const Contestant& contestant : list.contestants)
        EXPECT_TRUE(titles.insert(makeTitle(contestant)).second) << makeTitle(contestant);
    EXPECT_TRUE(titles.contains("Horizon sweep"));
    EXPECT_TRUE(titles.contains("Horizon sweep, error 0.1 %"));
    EXPECT_TRUE(titles.contains("Inverse accrual map, levels 6"));
    EXPECT_TRUE(titles.contains("Inverse accrual map, levels 8"));  // 12 clamped
}

TEST(BenchContestants, ALadderHasTheDefaultRungToo) {
    const auto ladder = listVariants(coreAndLabEngines(), "iam", "levels", {1, 2, 3});
    ASSERT_EQ(ladder.size(), 3U);
    EXPECT_EQ(ladder[0].setting, "levels 1");
    EXPECT_EQ(ladder[2].setting, "");
    EXPECT_TRUE(listVariants(coreAndLabEngines(), "none", "levels", {1}).empty());
}

}  // namespace

}  // namespace noonmark::bench
