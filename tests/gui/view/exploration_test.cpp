#include "app/gui/view/exploration/exploration.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "core/engines/ray/surface_rays.h"
#include "core/lab/accrual/surface_accrual.h"
#include "tests/gui/small_open_city.h"
#include "tests/gui/wait_for.h"

namespace noonmark {
namespace {

using test::waitFor;

const ViewLens smallLens{40, 160, 120};
const CameraPose slanting{{0, 0, 0}, 350, 20, 45};

Observer newYork() { return {{-73.98, 40.76}}; }

Period morning(int days = 1) {
    Period period;
    period.days = days;
    period.hours = 3;
    period.stepMinutes = 5;
    period.zone = "America/New_York";
    return period;
}

/// Refinement of a view of the small city.
struct Refinement : ::testing::Test {
    ViewQuestion question{test::smallOpenCity(), slanting, smallLens, morning(), newYork(), nullptr,
                          minTurnTests};
    ViewEngine engine{std::make_shared<SurfaceRays>(question.city->picker.scene())};
    NoProgress progress;

    // All answers, from the coarsest to the finest.
    std::vector<ViewAnswer> answers() {
        std::vector<ViewAnswer> all{refineView(question, nullptr, engine, progress, {}).value()};
        while (!isFinest(all.back()))
            all.push_back(refineView(question, &all.back(), engine, progress, {}).value());
        return all;
    }

    SurfaceShadow computeTruth(const ViewAnswer& answer) {
        return engine.accumulator
            ->accumulate(question.city->city(), answer.view.surface->points, *answer.sun, progress, {})
            .value();
    }
};

TEST_F(Refinement, GoesFromCoarseToEveryPixel) {
    const auto all = answers();
    ASSERT_EQ(all.size(), 4U);
    std::vector<int> spacing;
    for (const ViewAnswer& answer : all) spacing.push_back(answer.view.spacingPx);
    EXPECT_EQ(spacing, (std::vector{8, 4, 2, 1}));
    EXPECT_EQ(all.back().view.camera.widthPx, 160);
    EXPECT_EQ(all.back().view.camera.heightPx, 120);
    EXPECT_LT(all.front().view.surface->points.size() * 50, all.back().view.surface->points.size());
}

TEST_F(Refinement, BeginsCoarserWhereAViewHasVeryManyPixels) {
    question.lens = {40, 4096, 3072};
    question.period.hours = 10;
    question.period.stepMinutes = 1;
    const ViewAnswer first = refineView(question, nullptr, engine, progress, {}).value();
    EXPECT_EQ(first.view.spacingPx, 16);
    EXPECT_EQ(first.view.daysDone, 1) << "and has no holes";
    question.sun = first.sun;
    question.turnTests = 1e9;
    EXPECT_EQ(refineView(question, nullptr, engine, progress, {}).value().view.spacingPx, 8)
        << "where the machine is quick";
}

// The size of a turn follows the speed of the last one, and no turn exceeds the tests allowed.
TEST_F(Refinement, TurnsAreAsLongAsFivePicturesASecondAllow) {
    ViewAnswer answer;
    answer.turn.tests = 7e6;
    answer.turnSeconds = 0.1;
    EXPECT_GT(turnTestsAfter(answer), 7e6);
    EXPECT_LT(turnTestsAfter(answer), 14e6);
    answer.turnSeconds = 10;
    EXPECT_EQ(turnTestsAfter(answer), minTurnTests);
    answer.turnSeconds = 0;
    EXPECT_LT(turnTestsAfter(answer), 1e11);

    question.lens = {40, 320, 240};
    for (const double turnTests : {1e5, 3e5}) {
        question.turnTests = turnTests;
        for (const ViewAnswer& found : answers())
            EXPECT_TRUE(found.level == 1 || found.turn.tests <= turnTests) << found.level;
    }
}

TEST_F(Refinement, EveryLevelHoldsTheTruthOfItsSamples) {
    for (const ViewAnswer& answer : answers()) {
        const SurfaceShadow truth = computeTruth(answer);
        EXPECT_EQ(answer.view.shadow.grossMin, truth.grossMin);
        EXPECT_EQ(answer.view.shadow.continuousMin, truth.continuousMin);
        EXPECT_EQ(answer.view.shadow.sunlitMinutesPerDay, 180);
    }
}

// A slow day at full resolution is filled in part by part, over the values of the coarser level.
TEST_F(Refinement, PointsThatWaitShowWhatIsKnownAroundThem) {
    question.period.stepMinutes = 0.05;
    question.lens = {40, 300, 225};
    const auto all = answers();
    const ViewAnswer& half = all[all.size() - 2];
    ASSERT_EQ(half.level, all.back().level) << "the finest level takes several turns";
    const SurfaceShadow& finest = all.back().view.shadow;
    ASSERT_GT(half.view.pointsDone, 0U);
    EXPECT_EQ(half.view.daysShown, 1) << "every value is one of the whole day";
    int waiting = 0;
    int alike = 0;
    for (std::size_t i = 0; i < finest.grossMin.size(); ++i) {
        if (i < half.view.pointsDone) {
            ASSERT_EQ(half.view.shadow.grossMin[i], finest.grossMin[i]);
        } else if (!std::isnan(half.view.shadow.grossMin[i])) {
            ++waiting;
            if (std::abs(half.view.shadow.grossMin[i] - finest.grossMin[i]) < 3) ++alike;
        }
    }
    EXPECT_GT(waiting, int(finest.grossMin.size() - half.view.pointsDone) * 9 / 10);
    EXPECT_GT(alike, waiting * 9 / 10);
}

TEST_F(Refinement, ByAccrualMapsTakesAllDaysOfTheFinestLevelAtOnce) {
    engine = {SurfaceAccrual::make({}, {}).value(), false};
    question.period = morning(20);
    const auto all = answers();
    ASSERT_EQ(all.size(), 7U) << "a view of each finer level, then its shadow";
    EXPECT_EQ(all[5].view.daysDone, 0) << "visible surface at every pixel, with the coarser level's values";
    EXPECT_EQ(all[6].turn.days, 20);
    const SurfaceShadow rays =
        SurfaceRays()
            .accumulate(question.city->city(), all.back().view.surface->points, *all.back().sun, progress, {})
            .value();
    double error = 0;
    for (std::size_t i = 0; i < rays.grossMin.size(); ++i)
        error += std::abs(double(rays.grossMin[i] - all.back().view.shadow.grossMin[i]));
    EXPECT_LT(error / double(rays.grossMin.size()), 180 * 0.02);
}

// A partial result is shown once it covers more of the period than the present answer.
TEST_F(Refinement, ARunningResultTakesOverWhenItTellsMore) {
    engine = {SurfaceAccrual::make({}, {}).value(), false};
    question.period = morning(20);
    const auto all = answers();
    ViewAnswer begun = all[5];
    begun.view.daysShown = 5;
    PartialField running;
    running.field.grossMin.assign(begun.view.surface->points.size(), 3);
    running.field.continuousMin.assign(begun.view.surface->points.size(), 2);
    running.field.sunlitMinutesPerDay = 60;
    running.part = "4 of 12 sun intervals";
    running.share = 0.06;
    EXPECT_FALSE(withRunning(begun, running)) << "5 days of 20 at a quarter of the samples cover more";
    running.share = 0.07;
    const auto shown = withRunning(begun, running);
    ASSERT_TRUE(shown);
    EXPECT_EQ(shown->view.shadow.grossMin, running.field.grossMin);
    EXPECT_EQ(shown->view.shadow.sunlitMinutesPerDay, 60);
    EXPECT_TRUE(surfacePicture(shown->view, ShadowMeasure::gross, 180).soFar);
    EXPECT_TRUE(describeDetail(shown->view, 350).startsWith(QStringLiteral("4 of 12 sun intervals")));
    EXPECT_FALSE(withRunning(all[3], running)) << "of another level";
}

/// Accepts every partial result.
class Onlooker final : public Progress, public PartialSink {
public:
    void report(double, std::string_view) override {}
    [[nodiscard]] bool wants() const override { return true; }
    void take(PartialField partial) override { seen.push_back(std::move(partial)); }
    std::vector<PartialField> seen;
};

double offBy(const ExploredView& view, const ExploredView& truth) {
    double off = 0;
    for (std::size_t i = 0; i < view.shadow.grossMin.size(); ++i)
        if (const float minutes = view.shadow.grossMin[i]; !std::isnan(minutes))
            off += std::abs(double(minutes - truth.shadow.grossMin[i]));
    return off;
}

// A day is already known at a coarser level: partial results refine it step by step, at every level.
TEST_F(Refinement, ByAccrualMapsEachLevelOfADaySharpensStepByStep) {
    engine = {SurfaceAccrual::make({}, {}).value(), false};
    const auto all = answers();
    ASSERT_EQ(all.size(), 7U);
    for (const std::size_t begun : {1U, 3U, 5U}) {
        Onlooker onlooker;
        const ViewAnswer done = refineView(question, &all[begun], engine, onlooker, {}).value();
        EXPECT_EQ(done.view.shadow.grossMin, all[begun + 1].view.shadow.grossMin);
        ASSERT_GT(onlooker.seen.size(), 3U);
        double before = offBy(all[begun].view, done.view);
        ASSERT_GT(before, 0);
        for (const PartialField& running : onlooker.seen) {
            const auto shown = withRunning(all[begun], running);
            ASSERT_TRUE(shown) << running.part;
            EXPECT_EQ(shown->view.shadow.sunlitMinutesPerDay, 180) << "of all of the day";
            EXPECT_LE(offBy(shown->view, done.view), before * 1.01) << running.part;
            EXPECT_TRUE(coversPart(shown->view));
            EXPECT_TRUE(describeDetail(shown->view, 350).startsWith(QString::fromStdString(running.part)));
            before = offBy(shown->view, done.view);
        }
        EXPECT_EQ(before, 0) << "the last one is the answer";
    }
}

TEST_F(Refinement, SeesRoofsAndFacadesAndTheShadowOnThem) {
    const ViewAnswer finest = answers().back();
    int roofs = 0;
    int facades = 0;
    for (std::size_t i = 0; i < finest.view.surface->points.size(); ++i) {
        const glm::vec3 normal = finest.view.surface->points.normals[i];
        if (normal.z > 0.9F && finest.view.surface->points.positions[i].z > 20) ++roofs;
        if (normal.z < 0.1F) ++facades;
    }
    EXPECT_GT(roofs, 100);
    EXPECT_GT(facades, 300);
    const auto roof = finest.view.pointAt({0, -40, 60});
    ASSERT_TRUE(roof) << "the roof of South House is visible";
    EXPECT_EQ(finest.view.shadow.grossMin[*roof], 0) << "and sunlit, being higher than its surroundings";
}

// The cameras of the paper's figure: 800, 300 and 100 m above ground.
TEST_F(Refinement, NearerCamerasSeeFinerDetail) {
    double coarser = 1e9;
    for (const double height : {800.0, 300.0, 100.0}) {
        question.pose = {{-70, 60, 0}, height, 0, 90};
        const ViewAnswer finest = answers().back();
        const double sample = finest.view.sampleM(height);
        EXPECT_NEAR(sample, height * 2 * std::tan(glm::radians(20.0)) / 120, 1e-9);
        EXPECT_LT(sample, coarser / 2);
        coarser = sample;
        const auto point = finest.view.pointAt({-70, 60, 0});
        ASSERT_TRUE(point);
        const glm::dvec3 seen(finest.view.surface->points.positions[*point]);
        EXPECT_LT(glm::length(seen - glm::dvec3(-70, 60, 0)), sample) << "what a pixel shows is that near";
    }
}

// Many days are computed a few at a time; each answer is correct for its days, and states how many they are.
TEST_F(Refinement, LongPeriodsGrowDayByDayIntoTheWhole) {
    question.period = morning(300);
    question.period.stepMinutes = 2;
    question.lens = {40, 400, 300};
    ViewAnswer answer = refineView(question, nullptr, engine, progress, {}).value();
    ASSERT_EQ(answer.view.days, 300);
    const int coarseDays = answer.view.daysDone;
    EXPECT_GT(coarseDays, 1);
    EXPECT_LT(coarseDays, 300);
    question.sun = answer.sun;
    EXPECT_TRUE(surfacePicture(answer.view, ShadowMeasure::gross, 180).soFar);
    EXPECT_TRUE(describeDetail(answer.view, 350).contains(QStringLiteral("of 300 days")));
    const SurfaceShadow truth = computeTruth(answer);
    double error = 0;
    for (std::size_t i = 0; i < truth.grossMin.size(); ++i)
        error += std::abs(double(truth.grossMin[i] - answer.view.shadow.grossMin[i]));
    EXPECT_LT(error / double(truth.grossMin.size()), 2)
        << "error of scattered days against the whole period, minutes";
}

TEST_F(Refinement, PointsAndDaysTakenInTurnsAddUp) {
    question.period = morning(7);
    const ViewAnswer finest = answers().back();
    ExploredView view = finest.view;
    view.daysDone = 0;
    view.daysShown = 0;
    const double dayTests = double(view.surface->points.size()) * stepsADay(*finest.sun);
    std::vector<int> daysOfTurns;
    while (view.daysDone < 7) {
        const ViewTurn turn = nextTurn(view, {2, 7}, *finest.sun, dayTests * (view.daysDone < 4 ? 0.7 : 9));
        const SurfaceShadow found =
            engine.accumulator
                ->accumulate(question.city->city(), pointsOf(view.surface->points, turn),
                             daysOf(*finest.sun, view.daysDone, turn.days), progress, {})
                .value();
        join(view, turn, found);
        daysOfTurns.push_back(turn.days);
    }
    EXPECT_EQ(daysOfTurns, (std::vector{2, 2, 2, 1, 1, 1, 1, 3}))
        << "parts of two days, of one, then the rest";
    for (std::size_t i = 0; i < view.shadow.grossMin.size(); ++i) {
        ASSERT_NEAR(view.shadow.grossMin[i], finest.view.shadow.grossMin[i], 1e-3);
        ASSERT_EQ(view.shadow.continuousMin[i], finest.view.shadow.continuousMin[i]);
    }
    EXPECT_NEAR(view.shadow.sunlitMinutesPerDay, finest.view.shadow.sunlitMinutesPerDay, 1e-9);
}

TEST_F(Refinement, ASunThatNeverRisesIsReported) {
    question.period.from = std::chrono::hours(0);
    question.period.hours = 2;
    const auto answer = refineView(question, nullptr, engine, progress, {});
    ASSERT_FALSE(answer);
    EXPECT_NE(answer.error().what.find("below the horizon"), std::string::npos);
}

/// The same in jobs of the window.
struct ExplorationTest : ::testing::Test {
    Exploration exploration;
    std::vector<std::shared_ptr<const ViewAnswer>> seen;

    void SetUp() override {
        QObject::connect(&exploration, &Exploration::changed, [this] {
            if (exploration.answer()) seen.push_back(exploration.answer());
        });
        exploration.setCity(test::smallOpenCity());
        exploration.setPeriod(morning(), newYork());
        exploration.look(slanting, smallLens);
    }
    bool finest() { return exploration.answer() && isFinest(*exploration.answer()); }
};

TEST_F(ExplorationTest, ShowsCoarseFirstAndEndsFine) {
    exploration.setActive(true);
    ASSERT_TRUE(waitFor([this] { return finest() && !exploration.working(); }));
    std::vector<int> levels;
    for (const auto& answer : seen) levels.push_back(answer->level);
    EXPECT_EQ(levels, (std::vector{1, 2, 3, 4}));
}

TEST_F(ExplorationTest, ANewerViewOvertakesAnOlderOne) {
    exploration.setActive(true);
    CameraPose pose = slanting;
    for (int i = 0; i < 40; ++i) {
        pose.headingDeg += 2;
        exploration.look(pose, smallLens);
        QCoreApplication::processEvents(QEventLoop::AllEvents, 2);
    }
    ASSERT_TRUE(waitFor([this] { return finest() && !exploration.working(); }));
    EXPECT_EQ(exploration.answer()->view.camera.eye, computeEye(pose));
    const auto last = std::ranges::find_if(
        seen, [&](const auto& answer) { return answer->view.camera.eye == computeEye(pose); });
    EXPECT_TRUE(std::all_of(last, seen.end(), [&](const auto& answer) {
        return answer->view.camera.eye == computeEye(pose);
    })) << "no older view is shown after the newest";
}

TEST_F(ExplorationTest, AnotherPeriodBeginsAnew) {
    exploration.setActive(true);
    ASSERT_TRUE(waitFor([this] { return finest(); }));
    const auto before = exploration.answer();
    Period noon = morning();
    noon.from = std::chrono::hours(12);
    exploration.setPeriod(noon, newYork());
    ASSERT_TRUE(waitFor([this] { return finest(); }));
    EXPECT_EQ(before->view.surface->pixel, exploration.answer()->view.surface->pixel);
    EXPECT_NE(before->view.shadow.grossMin, exploration.answer()->view.shadow.grossMin);
}

TEST_F(ExplorationTest, RestsWhenInactiveAndGoesOnWhereItWas) {
    EXPECT_FALSE(exploration.working());
    exploration.setActive(true);
    ASSERT_TRUE(waitFor([this] { return exploration.answer() != nullptr; }));
    exploration.setActive(false);
    EXPECT_FALSE(exploration.working());
    const std::size_t before = seen.size();
    waitFor([] { return false; }, 50);
    EXPECT_EQ(seen.size(), before);
    exploration.setActive(true);
    ASSERT_TRUE(waitFor([this] { return finest(); }));
    EXPECT_EQ(seen[before]->level, seen[before - 1]->level + 1);
}

TEST(ExploredView, KnowsNothingBehindACornerOrBesideThePicture) {
    const auto city = test::smallOpenCity();
    ExploredView view;
    view.camera = makeExploredCamera({{0, -40, 0}, 300, 0, 30}, smallLens, 1);
    view.surface = std::make_shared<const VisibleSurface>(
        findVisibleSurface(city->picker.scene().value(), true, view.camera).value());
    EXPECT_TRUE(view.pointAt({0, -60, 30})) << "the southern front";
    EXPECT_FALSE(view.pointAt({0, -20, 30})) << "the northern front is behind it";
    EXPECT_FALSE(view.pointAt({0, -600, 0})) << "behind the eye";
    EXPECT_FALSE(view.pointAt({400, -40, 0})) << "beside the picture";
}

}  // namespace
}  // namespace noonmark
