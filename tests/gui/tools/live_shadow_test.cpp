#include "app/gui/tools/live/live_shadow.h"

#include <gtest/gtest.h>

#include "core/engines/projected/projected_shadows.h"
#include "core/engines/ray/ray_reference.h"
#include "tests/gui/live_scene.h"

namespace noonmark {
namespace {

using namespace test;

struct LiveShadowTest : ::testing::Test {
    NoProgress progress;
    std::shared_ptr<SharedHorizonCache> horizons = std::make_shared<SharedHorizonCache>();

    std::shared_ptr<LiveShadow> at(const City& city, const LiveQuestion& question) {
        return LiveShadow::at(placeIn(city), question, horizons, progress, {}).value();
    }
    LiveAnswer answer(LiveShadow& live, const LiveReceivers::Shape& shape,
                      ShadowCounts counts = ShadowCounts::grossAndRuns) {
        return live.with(shape, counts, progress, {}).value();
    }
    // Equal, bit for bit, to a study of the city with the shape on these cells.
    void expectFresh(const LiveAnswer& answer, const City& city, const Period& period) {
        const ShadowField fresh = freshHorizons(city, answer.receivers, period);
        EXPECT_TRUE(sameBits(answer.field.grossMin, fresh.grossMin));
        EXPECT_TRUE(!answer.runs || sameBits(answer.field.continuousMin, fresh.continuousMin));
    }
};

LiveQuestion asked(const Period& period, ReceiverPlaces places = ReceiverPlaces::ground) {
    return {sunOf(period), {}, {.cellM = 1, .places = places}};
}

TEST(LiveLimits, PolygonsWhereTheyAreExactAndHorizonsElsewhere) {
    using enum LiveEngine;
    City city = smallCity();
    const auto engines = [&](ReceiverPlaces places, std::size_t steps) {
        return liveEngines(city, places, steps);
    };
    using Engines = std::vector<LiveEngine>;
    EXPECT_EQ(engines(ReceiverPlaces::ground, 720), (Engines{shadows, horizons}));
    EXPECT_EQ(engines(ReceiverPlaces::ground, 721), (Engines{horizons, moments}));
    EXPECT_EQ(engines(ReceiverPlaces::both, 1), Engines{horizons});
    EXPECT_EQ(engines(ReceiverPlaces::roofs, 1), Engines{horizons});
    city.terrain = slope();
    EXPECT_EQ(engines(ReceiverPlaces::ground, 1), Engines{horizons});
    EXPECT_EQ(engines(ReceiverPlaces::ground, 10000), Engines{horizons});
}

TEST(LiveLimits, WordsSayHowExactItIs) {
    EXPECT_EQ(describeExactness(LiveEngine::shadows, 360, 360, true), "exact at all 360 steps");
    EXPECT_EQ(describeExactness(LiveEngine::moments, 120, 175200, false), "exact at 120 of 175,200 steps");
    const QString gross = describeExactness(LiveEngine::horizons, 175200, 175200, false);
    EXPECT_TRUE(gross.contains("all 175,200 steps")) << gross.toStdString();
    EXPECT_TRUE(gross.contains("0.25°")) << gross.toStdString();
    EXPECT_TRUE(gross.contains("continuous shadow follows")) << gross.toStdString();
    EXPECT_FALSE(describeExactness(LiveEngine::horizons, 1, 1, true).contains("follows"));
}

TEST_F(LiveShadowTest, IsThatOfAStudyOfTheCityWithTheTower) {
    const Period period = spring(1, 2);
    const auto live = at(smallCity(), asked(period));
    EXPECT_EQ(live->engine(), LiveEngine::shadows);
    const LiveAnswer shown = answer(*live, tower(), ShadowCounts::gross);
    EXPECT_TRUE(shown.runs) << "polygons include continuous shadow at once";
    EXPECT_EQ(shown.counted, shown.steps);
    const SunQuestion sun = sunOf(period);
    const auto study = ProjectedShadows()
                           .accumulate(with(smallCity(), tower()), shown.receivers,
                                       computeSunSteps(sun.period, sun.observer).value(), progress, {})
                           .value();
    EXPECT_TRUE(sameBits(shown.field.grossMin, study.grossMin));
    EXPECT_TRUE(sameBits(shown.field.continuousMin, study.continuousMin));
    double shaded = 0;
    for (const std::uint32_t cell : shown.receivers.cells) shaded += double(shown.field.grossMin[cell]);
    EXPECT_GT(shaded, 10000);
}

TEST_F(LiveShadowTest, FollowsAShapeThatMovesAndGoes) {
    const auto live = at(smallCity(), asked(spring(1, 2)));
    const LiveAnswer before = answer(*live, {}), first = answer(*live, tower()),
                     second = answer(*live, tower(15)), again = answer(*live, tower()),
                     after = answer(*live, {});
    EXPECT_TRUE(sameBits(again.field.grossMin, first.field.grossMin));
    EXPECT_TRUE(sameBits(after.field.continuousMin, before.field.continuousMin));
    EXPECT_FALSE(sameBits(second.field.grossMin, first.field.grossMin));
    EXPECT_EQ(std::ranges::count(first.receivers.kind, CellKind::building) -
                  std::ranges::count(before.receivers.kind, CellKind::building),
              900)
        << "under the tower nothing is measured";
}

TEST_F(LiveShadowTest, OnTerrainItIsThatOfFreshHorizonsAndNearTheRays) {
    const City city = smallCityOnASlope();
    const Period period = spring(1, 5);
    const auto live = at(city, asked(period));
    ASSERT_EQ(live->engine(), LiveEngine::horizons);
    for (const float east : {0.0F, 12.5F, -40.0F, 0.0F}) {
        const auto shape = tower(east, 15);
        expectFresh(answer(*live, shape), with(city, shape), period);
    }
    const LiveAnswer shown = answer(*live, tower(0, 15));
    const SunQuestion sun = sunOf(period);
    const auto truth = RayReference()
                           .accumulate(with(city, tower(0, 15)), shown.receivers,
                                       computeSunSteps(sun.period, sun.observer).value(), progress, {})
                           .value();
    double off = 0, shaded = 0;
    for (const std::uint32_t cell : shown.receivers.cells) {
        off += std::abs(double(shown.field.grossMin[cell] - truth.grossMin[cell]));
        shaded += double(truth.grossMin[cell]);
    }
    EXPECT_GT(shaded, 10000);
    EXPECT_LT(off / double(shown.receivers.cells.size()), 0.01 * 180) << "minutes of 180";
}

TEST_F(LiveShadowTest, OfALongPeriodEveryStepCounts) {
    const City city = smallCity();
    const Period period = spring(30, 5);
    const auto live = at(city, asked(period));
    ASSERT_EQ(live->engine(), LiveEngine::horizons);
    const LiveAnswer gross = answer(*live, tower(), ShadowCounts::gross);
    EXPECT_FALSE(gross.runs);
    EXPECT_EQ(gross.steps, 30U * 36U);
    EXPECT_EQ(gross.counted, gross.steps);
    expectFresh(gross, with(city, tower()), period);
    const LiveAnswer rested = answer(*live, tower());
    EXPECT_TRUE(rested.runs);
    expectFresh(rested, with(city, tower()), period);
    EXPECT_EQ(horizons->sets(), 1);
}

TEST_F(LiveShadowTest, OnRoofsTheyFollowToo) {
    const City city = smallCity();
    const Period period = spring(1, 5);
    LiveQuestion question = asked(period, ReceiverPlaces::both);
    question.region = makeRegionFromLocalBox({{-120, -120}, {120, 120}});
    question.onRegion = true;
    const auto live = at(city, question);
    for (const float east : {0.0F, 45.0F, -10.0F}) {
        const City edited = with(city, tower(east));
        const LiveAnswer shown = answer(*live, tower(east));
        const Receivers fresh = placeReceivers(edited, question.region, question.receivers).value();
        ASSERT_EQ(shown.receivers.grid, fresh.grid) << "the study's cells";
        EXPECT_EQ(shown.receivers.kind, fresh.kind);
        EXPECT_EQ(shown.receivers.groundM, fresh.groundM);
        EXPECT_EQ(shown.receivers.cells, fresh.cells);
        expectFresh(shown, edited, period);
    }
    EXPECT_EQ(horizons->sets(), 1);
}

TEST_F(LiveShadowTest, OfRoofsAloneTheGroundIsLeftOut) {
    const Period period = spring(1, 10);
    const auto both = at(smallCity(), asked(period, ReceiverPlaces::both));
    const LiveAnswer all = answer(*both, tower());
    const auto live = at(smallCity(), asked(period, ReceiverPlaces::roofs));
    const LiveAnswer roofs = answer(*live, tower());
    EXPECT_EQ(std::ranges::count(all.receivers.kind, CellKind::roof),
              std::ptrdiff_t(roofs.receivers.cells.size()));
    EXPECT_GT(roofs.receivers.cells.size(), 2000U);
    for (std::size_t cell = 0; cell < roofs.receivers.kind.size(); ++cell) {
        if (roofs.receivers.kind[cell] == CellKind::roof) {
            ASSERT_EQ(roofs.field.grossMin[cell], all.field.grossMin[cell]);
        } else {
            ASSERT_TRUE(std::isnan(roofs.field.grossMin[cell]));
        }
    }
    EXPECT_EQ(horizons->sets(), 1) << "the ground is cached, but not shown";
}

TEST_F(LiveShadowTest, IsOnTheRegionWhereTheShadowReachesItAndItIsNotTooLarge) {
    LiveQuestion question = asked(spring(1, 10));
    question.onRegion = true;
    const auto cells = [&](Box2 box) {
        question.region = makeRegionFromLocalBox(box);
        return at(smallCity(), question)->receivers().grid;
    };
    EXPECT_EQ(cells({{-150, -100}, {150, 100}}).columns, 300);
    EXPECT_EQ(cells({{-300, -100}, {-100, 100}}).columns, 200) << "beside it, to the west";
    EXPECT_EQ(cells({{5000, 5000}, {5200, 5200}}).columns, 400) << "out of reach: the square";
    EXPECT_EQ(cells({{-3000, -3000}, {3000, 3000}}).columns, 400) << "36 million cells: the square";
    question.onRegion = false;
    EXPECT_EQ(cells({{-150, -100}, {150, 100}}).columns, 400);
}

TEST_F(LiveShadowTest, WhereTooMuchHangsForHorizonsMomentsAreShown) {
    City city = smallCity();
    Building rack{.sourceId = "rack"};
    for (int i = 0; i <= 50'000; ++i)
        rack.parts.push_back(
            {.footprint = square({-90, -90}, 1), .bottomM = 5, .topM = 6, .isOverhanging = true});
    city.buildings.push_back(std::make_shared<const Building>(rack));
    const Period period = spring(4, 0.8);
    const auto some = at(city, asked(period));
    EXPECT_EQ(some->engine(), LiveEngine::moments);
    const LiveAnswer a = answer(*some, tower());
    EXPECT_EQ(a.counted, LiveLimits::sampledMoments);
    EXPECT_EQ(a.steps, 900U);
    EXPECT_FALSE(a.runs);
    city.buildings.pop_back();
    const auto all = at(city, asked(period));
    const LiveAnswer b = answer(*all, tower());
    EXPECT_DOUBLE_EQ(a.field.sunlitMinutesPerDay, b.field.sunlitMinutesPerDay);
    double difference = 0;
    for (const std::uint32_t cell : a.receivers.cells)
        difference += std::abs(double(a.field.grossMin[cell]) - double(b.field.grossMin[cell]));
    EXPECT_LT(difference / double(a.receivers.cells.size()), 1.5) << "minutes of 180";
    city.terrain = slope();
    city.buildings.push_back(std::make_shared<const Building>(rack));
    EXPECT_FALSE(LiveShadow::at(placeIn(city), asked(period), horizons, progress, {}))
        << "no other method works on a slope";
}

TEST_F(LiveShadowTest, NightIsRefused) {
    Period night = spring(1, 2);
    night.from = std::chrono::hours(0);
    EXPECT_FALSE(LiveShadow::at(placeIn(smallCity()), asked(night), horizons, progress, {}));
    City city = smallCity();
    city.terrain = slope();
    EXPECT_FALSE(LiveShadow::at(placeIn(city), asked(night), horizons, progress, {}));
}

}  // namespace
}  // namespace noonmark
