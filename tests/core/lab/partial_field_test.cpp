#include <fmt/format.h>
#include <gtest/gtest.h>
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <vector>

#include "core/engines/api/shadow_field.h"
#include "core/engines/projected/projected_shadows.h"
#include "core/lab/accrual/shadow_accrual_map.h"
#include "core/lab/graph/graph_engine.h"
#include "core/lab/graph/ray_intervals.h"
#include "core/lab/inverse/inverse_accrual_map.h"
#include "core/sun/sun_steps.h"
#include "tests/core/engines/scenes.h"

namespace noonmark::tests {

namespace {

/// Receives every running result, or only those that are sent without asking.
class Onlooker final : public Progress, public PartialSink {
public:
    explicit Onlooker(bool curious = true) : curious_(curious) {}
    void report(double, std::string_view) override {}
    [[nodiscard]] bool wants() const override { return curious_; }
    void take(PartialField partial) override { seen.push_back(std::move(partial)); }
    std::vector<PartialField> seen;

private:
    bool curious_;
};

struct Partials : ::testing::Test {
    City city = cityOf({{{20, 20, 0}, {30, 34, 25}}, {{50, 10, 0}, {58, 30, 40}}});
    Receivers receivers = receiversOver(city, 0, 0, 100, 80);
    SunSteps sun;

    void SetUp() override { addThreeDays(); }

    void addThreeDays() {
        for (const double lift : {0.0, 6.0, 12.0}) {
            std::vector<Sun> suns;
            for (int k = 0; k < 150; ++k) suns.push_back({120 + 0.8 * k, 12 + lift + 0.1 * k});
            addDay(sun, suns);
        }
    }

    [[nodiscard]] ShadowField fieldOf(const Engine& engine, Progress& progress) const {
        return engine.accumulate(city, receivers, sun, progress, {}).value();
    }
};

bool same(float a, float b) { return a == b || (std::isnan(a) && std::isnan(b)); }

// Number of receivers with a known value; each must equal the value in `truth`.
std::size_t knownAndTrue(const std::vector<float>& part, const std::vector<float>& truth) {
    std::size_t known = 0;
    for (std::size_t i = 0; i < part.size(); ++i) {
        if (std::isnan(part[i])) continue;
        EXPECT_EQ(part[i], truth[i]) << i;
        ++known;
    }
    return known;
}

void expectSame(const std::vector<float>& a, const std::vector<float>& b) {
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t i = 0; i < a.size(); ++i)
        ASSERT_TRUE(same(a[i], b[i])) << i << ": " << a[i] << " " << b[i];
}

TEST_F(Partials, OfTheRayReferenceHoldFinalValues) {
    Onlooker onlooker;
    const ShadowField field = fieldOf(RayReference(), onlooker);
    ASSERT_GT(onlooker.seen.size(), 20U);
    double share = 0;
    for (const PartialField& partial : onlooker.seen) {
        EXPECT_GE(partial.share, share);
        share = partial.share;
        const std::size_t known = knownAndTrue(partial.field.grossMin, field.grossMin);
        EXPECT_EQ(known, knownAndTrue(partial.field.continuousMin, field.continuousMin));
        EXPECT_NEAR(double(known) / double(receivers.cells.size()), share, 0.12);
        EXPECT_EQ(partial.field.sunlitMinutesPerDay, field.sunlitMinutesPerDay);
    }
}

TEST_F(Partials, LastIsTheResult) {
    const GraphEngine graph(InverseAccrualMap::make({}).value(), {});
    const RayReference rays;
    const ProjectedShadows projected;
    for (const Engine* engine : std::initializer_list<const Engine*>{&graph, &rays, &projected}) {
        Onlooker onlooker(false);
        const ShadowField field = fieldOf(*engine, onlooker);
        ASSERT_EQ(onlooker.seen.size(), 1U) << "nobody wanted more";
        EXPECT_EQ(onlooker.seen.back().share, 1);
        expectSame(onlooker.seen.back().field.grossMin, field.grossMin);
        expectSame(onlooker.seen.back().field.continuousMin, field.continuousMin);
        EXPECT_EQ(onlooker.seen.back().field.sunlitMinutesPerDay, field.sunlitMinutesPerDay);
    }
}

// The same bits with and without a watcher; running results are the fields of some of the days.
TEST_F(Partials, OfProjectedShadowsAreTrueForTheDaysDone) {
    const ProjectedShadows engine;
    NoProgress unwatched;
    const ShadowField whole = fieldOf(engine, unwatched);
    Onlooker onlooker;
    const ShadowField field = fieldOf(engine, onlooker);
    expectSame(field.grossMin, whole.grossMin);
    expectSame(field.continuousMin, whole.continuousMin);
    ASSERT_GE(onlooker.seen.size(), 2U);
    const PartialField& first = onlooker.seen.front();
    EXPECT_EQ(first.part, "1 of 3 days");
    const std::size_t firstDay = 0;
    const SunSteps day = chooseDays(sun, {&firstDay, 1});
    const ShadowField truth = engine.accumulate(city, receivers, day, unwatched, {}).value();
    EXPECT_DOUBLE_EQ(first.field.sunlitMinutesPerDay, 50) << "150 minutes over three days";
    for (const std::uint32_t cell : receivers.cells)
        ASSERT_NEAR(first.field.grossMin[cell], truth.grossMin[cell] / 3, 1e-4);
    expectSame(first.field.continuousMin, truth.continuousMin);
}

TEST_F(Partials, OfTheRayReferenceFillTheWholeRegionEarly) {
    Onlooker onlooker;
    const ShadowField field = fieldOf(RayReference({.threads = 1}), onlooker);
    const auto early = std::find_if(onlooker.seen.begin(), onlooker.seen.end(),
                                    [](const PartialField& partial) { return partial.share > 0.15; });
    std::array<int, 4> known{};
    for (const std::uint32_t cell : receivers.cells)
        if (!std::isnan(early->field.grossMin[cell]))
            ++known[(cell % 100 >= 50 ? 1U : 0U) + (cell >= 40 * 100 ? 2U : 0U)];
    for (const int quarter : known) EXPECT_GT(quarter, 64) << "cells known of a quarter of the region";
    EXPECT_NE(early->part.find(" of 130 tiles"), std::string::npos) << early->part;
}

// The first `intervals` intervals of one hour or the remainder, of days of 150 minutes.
SunSteps beginningOf(const SunSteps& sun, std::size_t intervals) {
    SunSteps part = sun;
    for (SunDay& day : part.days) {
        const std::size_t whole = std::min<std::size_t>(intervals, 3);
        intervals -= whole;
        day.count = std::min<std::uint32_t>(150, std::uint32_t(whole) * 60);
    }
    return part;
}

// During an interval, a running result covers the steps finished so far, on one of three days.
TEST_F(Partials, OfAnIntervalAreTrueForTheStepsDone) {
    const DirectionGraphSettings apart{.merge = false};
    const DirectionGraph graph = buildDirectionGraph(sun, apart).value();
    const SunInterval first = graph.edges[graph.paths[0][0].edge].sun;
    const auto accrual = ShadowAccrualMap::make({}).value();
    for (const std::shared_ptr<const IntervalEngine>& engine :
         {std::shared_ptr<const IntervalEngine>(std::make_shared<RayIntervals>()),
          std::shared_ptr<const IntervalEngine>(accrual)}) {
        const auto scene = engine->prepare(city, receivers, collectDirections(graph), {}).value();
        std::vector<ShadowMask> masks(receivers.cells.size());
        ASSERT_TRUE(scene->shade(first, masks, {}).has_value());
        Onlooker onlooker;
        NoProgress unwatched;
        const ShadowField field = fieldOf(GraphEngine(engine, apart), onlooker);
        expectSame(field.grossMin, fieldOf(GraphEngine(engine, apart), unwatched).grossMin);
        const PartialField& early = onlooker.seen.front();
        const int steps = int(std::lround(early.field.sunlitMinutesPerDay * 3));
        EXPECT_GT(steps, 0);
        EXPECT_LT(steps, 60);
        EXPECT_EQ(early.part, fmt::format("0 of 9 sun intervals, {} of 60 steps of the next", steps));
        EXPECT_NEAR(early.share, steps / 60.0 / 9, 1e-9);
        for (std::size_t i = 0; i < masks.size(); ++i) {
            const MaskRuns runs = measureRuns(masks[i] & fullMask(steps), steps);
            EXPECT_NEAR(early.field.grossMin[receivers.cells[i]], runs.gross / 3.0, 1e-4);
            EXPECT_EQ(early.field.continuousMin[receivers.cells[i]], float(runs.longest));
        }
    }
}

/// A day computed with maps, and the masks of its steps.
struct PartialsOfADay : Partials {
    GraphEngine engine{ShadowAccrualMap::make({}).value(), {}};
    StepsAround around;
    NoProgress unwatched;

    void SetUp() override {
        Partials::SetUp();
        const std::size_t day = 1;
        sun = chooseDays(sun, {&day, 1});
        EdgeMasks masks;
        static_cast<void>(engine.accumulate(city, receivers, sun, unwatched, {}, {nullptr, &masks}).value());
        ASSERT_EQ(masks.size(), 3U) << "two hours and a half";
        around.masks = std::make_shared<const EdgeMasks>(std::move(masks));
        for (std::uint32_t i = 0; i < receivers.cells.size(); ++i) around.nearest.push_back(i);
    }

    std::vector<PartialField> seenOn(const StepsAround& known) const {
        Onlooker onlooker;
        const StepMemory memory{&known, nullptr};
        const ShadowField field = engine.accumulate(city, receivers, sun, onlooker, {}, memory).value();
        NoProgress nobody;
        expectSame(field.grossMin, fieldOf(engine, nobody).grossMin);
        return onlooker.seen;
    }
};

TEST_F(PartialsOfADay, StandOnWhatIsKnownAround) {
    const ShadowField truth = fieldOf(engine, unwatched);
    const auto seen = seenOn(around);
    ASSERT_GT(seen.size(), 6U);
    for (const PartialField& partial : seen) {
        EXPECT_TRUE(partial.wholePeriod);
        EXPECT_EQ(partial.field.sunlitMinutesPerDay, 150);
        expectSame(partial.field.grossMin, truth.grossMin);
        expectSame(partial.field.continuousMin, truth.continuousMin);
    }
    EXPECT_EQ(seen.front().part, "0 of 3 sun intervals, 12 of 60 steps of the next");
}

TEST_F(PartialsOfADay, TakeTheStepsToComeFromAroundAndNoOthers) {
    EdgeMasks dark = *around.masks;
    for (std::size_t edge = 0; edge < dark.size(); ++edge)
        dark[edge].assign(dark[edge].size(), fullMask(edge == 2 ? 30 : 60));
    const auto seen = seenOn({std::make_shared<const EdgeMasks>(dark), around.nearest});
    const PartialField& hour = *std::ranges::find(seen, "1 of 3 sun intervals", &PartialField::part);
    for (std::size_t i = 0; i < receivers.cells.size(); ++i)
        ASSERT_EQ(hour.field.grossMin[receivers.cells[i]], float(std::popcount((*around.masks)[0][i]) + 90));
    for (std::size_t i = 1; i < seen.size(); ++i) EXPECT_GE(seen[i].share, seen[i - 1].share);
}

TEST_F(PartialsOfADay, AreOfTheStepsDoneWhereSeveralDaysAreAsked) {
    addThreeDays();
    for (const PartialField& partial : seenOn(around)) EXPECT_FALSE(partial.wholePeriod);
}

TEST_F(Partials, OfADirectionGraphAreTrueForTheIntervalsDone) {
    // Without merging, intervals are shaded in time order, so a running result is the study of a shorter
    // period.
    const GraphEngine engine(InverseAccrualMap::make({}).value(), {.merge = false});
    Onlooker onlooker;
    static_cast<void>(fieldOf(engine, onlooker));
    ASSERT_EQ(onlooker.seen.size(), 10U) << "after each of nine intervals, and at the end";
    for (std::size_t done = 1; done <= 9; ++done) {
        const PartialField& partial = onlooker.seen[done - 1];
        NoProgress progress;
        const SunSteps part = beginningOf(sun, done);
        const ShadowField truth = engine.accumulate(city, receivers, part, progress, {}).value();
        expectSame(partial.field.grossMin, truth.grossMin);
        expectSame(partial.field.continuousMin, truth.continuousMin);
        EXPECT_EQ(partial.part, std::to_string(done) + " of 9 sun intervals");
        EXPECT_DOUBLE_EQ(partial.share, double(done) / 9);
    }
}

}  // namespace

}  // namespace noonmark::tests

namespace noonmark {

namespace {

// Times at which results are taken by work that checks every `stepS`, starting late.
std::vector<double> takenBy(double stepS, double untilS) {
    PartialPace pace;
    std::vector<double> taken;
    for (int look = 1; 1 + look * stepS < untilS; ++look) {
        const double now = 1 + look * stepS;
        if (!pace.due(now)) continue;
        pace.taken(now);
        taken.push_back(now);
    }
    return taken;
}

TEST(PartialPace, FiveASecondHoweverOftenTheWorkLooksUp) {
    for (const double stepS : {0.001, 0.03, 0.07, 0.11, 0.17}) {
        const auto taken = takenBy(stepS, 21);
        EXPECT_GE(double(taken.size()) / (taken.back() - 1), 5) << stepS;
        EXPECT_LE(double(taken.size()), 20 / PartialPace::defaultS + 2) << "and no more than that, " << stepS;
    }
}

TEST(PartialPace, WorkThatSeldomLooksUpShowsAllItHas) {
    EXPECT_GE(double(takenBy(0.25, 21).size()), 0.9 * 20 / 0.25);
}

TEST(PartialPace, ALongPauseIsNotMadeGood) {
    PartialPace pace;
    pace.taken(0);
    ASSERT_TRUE(pace.due(10));
    pace.taken(10);
    EXPECT_FALSE(pace.due(10.1));
    EXPECT_TRUE(pace.due(10 + PartialPace::defaultS));
}

TEST(PartialPace, OnesThatComeUnaskedDoNotAddUp) {
    PartialPace pace;
    for (int i = 0; i < 10; ++i) pace.taken(1 + 0.01 * i);
    EXPECT_FALSE(pace.due(1.1));
    EXPECT_TRUE(pace.due(1.1 + PartialPace::defaultS));
}

}  // namespace

}  // namespace noonmark
