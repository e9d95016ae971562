#include "app/gui/tools/live/live_effects.h"

#include <gtest/gtest.h>

#include <latch>
#include <thread>

#include "tests/gui/live_scene.h"
#include "tests/gui/wait_for.h"

namespace noonmark {
namespace {

using namespace test;

/// Another user of the shared horizons, which blocks them until released.
class Asking final : public Progress {
public:
    explicit Asking(SharedHorizonCache& horizons)
        : thread_([this, &horizons] {
              const City city = smallCity();
              const auto receivers =
                  placeReceiversOnGround(city, makeRegionFromLocalBox({{-50, -50}, {50, 50}}), {.cellM = 5})
                      .value();
              (void)horizons.field(city, receivers, sunOf(spring(1, 30)), ShadowCounts::gross, *this, {});
          }) {
        begun_.wait();
    }
    void report(double, std::string_view) override {
        if (!said_.exchange(true)) begun_.count_down();
        end_.wait();
    }
    void letGo() { end_.count_down(); }

private:
    std::atomic<bool> said_ = false;
    std::latch begun_{1}, end_{1};
    std::jthread thread_;
};

struct LiveFollowerTest : ::testing::Test {
    std::shared_ptr<SharedHorizonCache> horizons = std::make_shared<SharedHorizonCache>();
    LiveFollower follower{horizons};
    City city = smallCityOnASlope();
    Period period = spring(20, 10);
    std::vector<std::shared_ptr<const LiveAnswer>> answers;
    std::vector<Error> errors;

    void SetUp() override {
        QObject::connect(&follower, &LiveFollower::changed, &follower,
                         [this] { answers.push_back(follower.answer()); });
        QObject::connect(&follower, &LiveFollower::failed, &follower,
                         [this](const Error& error) { errors.push_back(error); });
    }
    void begin() { follower.begin(placeIn(city), {sunOf(period), {}, {}}); }
    bool rests() {
        return waitFor([this] { return !errors.empty() || (!answers.empty() && answers.back()->runs); });
    }
};

TEST_F(LiveFollowerTest, EndsAtTheNewestShapeWithItsRuns) {
    begin();
    Asking other(*horizons);
    for (int step = 0; step < 12; ++step) {
        follower.follow(tower(float(step), 15));
        QCoreApplication::processEvents();
    }
    EXPECT_TRUE(answers.empty());
    other.letGo();
    ASSERT_TRUE(rests());
    ASSERT_TRUE(errors.empty());
    ASSERT_EQ(answers.size(), 3U) << "the first shape, the newest, and its continuous shadow";
    EXPECT_FALSE(answers[1]->runs);
    const City edited = with(city, tower(11, 15));
    const ShadowField fresh = freshHorizons(edited, answers[2]->receivers, period);
    EXPECT_TRUE(sameBits(answers[1]->field.grossMin, fresh.grossMin));
    EXPECT_TRUE(sameBits(answers[2]->field.grossMin, fresh.grossMin));
    EXPECT_TRUE(sameBits(answers[2]->field.continuousMin, fresh.continuousMin));
    EXPECT_EQ(follower.ageSeconds(), 0);
}

TEST_F(LiveFollowerTest, AnAnswerOfAnOlderShapeHasAnAge) {
    begin();
    follower.follow(tower(0, 15));
    ASSERT_TRUE(rests());
    int aged = 0;
    QObject::connect(&follower, &LiveFollower::aged, &follower, [&] { ++aged; });
    Asking other(*horizons);
    follower.follow(tower(3, 15));
    ASSERT_TRUE(waitFor([&] { return aged > 0; }));
    EXPECT_GT(follower.ageSeconds(), 0);
    EXPECT_TRUE(answers.back()->runs) << "the previous answer is shown";
    other.letGo();
    ASSERT_TRUE(waitFor([&] { return !answers.back()->runs; }));
    EXPECT_EQ(follower.ageSeconds(), 0);
}

TEST_F(LiveFollowerTest, CancelledItEndsAndTheNextPlaceBeginsAnew) {
    begin();
    Asking other(*horizons);
    follower.follow(tower(0, 15));
    follower.working().cancel();
    ASSERT_TRUE(waitFor([this] { return !errors.empty(); }));
    EXPECT_TRUE(isCancelled(errors.front()));
    follower.follow(tower(3, 15));
    EXPECT_FALSE(follower.working().busy()) << "the follower is inactive";
    other.letGo();
    errors.clear();
    begin();
    follower.follow(tower(3, 15));
    ASSERT_TRUE(rests());
    EXPECT_TRUE(errors.empty());
    EXPECT_TRUE(answers.back()->runs);
}

TEST_F(LiveFollowerTest, AnotherPlaceTakesTheWorkOver) {
    begin();
    follower.follow(tower(0, 15));
    city = smallCity();
    period = spring(1, 10);
    begin();
    EXPECT_FALSE(follower.answer());
    follower.follow(tower());
    ASSERT_TRUE(waitFor([this] { return !answers.empty(); }));
    EXPECT_EQ(answers.front()->engine, LiveEngine::shadows);
    follower.end();
    EXPECT_FALSE(follower.answer());
    follower.follow(tower(4));
    EXPECT_FALSE(follower.working().busy());
}

TEST_F(LiveFollowerTest, NightIsAnErrorOnce) {
    period.from = std::chrono::hours(0);
    begin();
    follower.follow(tower(0, 15));
    ASSERT_TRUE(waitFor([this] { return !errors.empty(); }));
    EXPECT_FALSE(isCancelled(errors.front()));
    EXPECT_TRUE(answers.empty());
}

}  // namespace
}  // namespace noonmark
