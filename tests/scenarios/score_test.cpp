#include "scenarios/weights/score.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/city/trees/tree.h"
#include "core/city/trees/tree_facts.h"
#include "core/engines/horizon/horizon_sweep.h"
#include "core/engines/projected/projected_shadows.h"
#include "scenarios/project/results/saved_figures_json.h"
#include "scenarios/weights/score_text.h"
#include "tests/scenarios/small_town.h"

namespace noonmark::tests {
namespace {

using namespace std::chrono;
using namespace std::chrono_literals;
using testing::AllOf;
using testing::HasSubstr;

StudySettings year() {
    StudySettings settings;
    settings.region = makeRegionFromLocalBox({{-20, -20}, {90, 60}});
    settings.receivers.cellM = 5;
    settings.period = {.start = 2026y / January / 1,
                       .days = 365,
                       .from = 8h,
                       .hours = 8,
                       .stepMinutes = 60,
                       .zone = "America/New_York"};
    settings.engine = "ray";
    return settings;
}

Score scored(const StudySettings& settings, const TimeWeights& weights) {
    NoProgress progress;
    return runScore(threeHouses(), settings, weights, progress, {}).value();
}

Study studied(const StudySettings& settings) {
    NoProgress progress;
    return runStudy(threeHouses(), settings, progress, {}).value();
}

TEST(TimeWeights, TheDefaultIsThePapersTable) {
    const TimeWeights table = makeMonthlyWeights();
    std::vector<double> weights;
    for (const WeightedInterval& interval : table.intervals) weights.push_back(interval.weight);
    EXPECT_THAT(weights, testing::ElementsAre(-1, -1, -0.5, 0, 0.5, 1, 1, 1, 0.5, 0, -0.5, -1));
    EXPECT_TRUE(validate(table));
    EXPECT_TRUE(table.intervals[1].holds(2028y / February / 29, 12h));
    EXPECT_FALSE(table.intervals[1].holds(2026y / March / 1, 0h));
}

TEST(TimeWeights, WhatMakesNoSenseIsRefused) {
    TimeWeights table{"mine", {{.name = "all", .weight = 2}}};
    EXPECT_THAT(validate(table).error().text(), HasSubstr("-1 (unwanted"));
    table.intervals[0].weight = 1;
    EXPECT_TRUE(validate(table));
    table.intervals.push_back({.name = "winter", .first = December / 1, .last = February / 1, .weight = -1});
    EXPECT_THAT(validate(table).error().text(), HasSubstr("'all' and 'winter' overlap"));
    EXPECT_FALSE(validate(TimeWeights{"", {{.weight = 1}}}));
    EXPECT_FALSE(validate(TimeWeights{"none", {}}));
    EXPECT_FALSE(validate(TimeWeights{"no time", {{.from = 12h, .to = 12h, .weight = 1}}}));
}

TEST(TimeWeights, AnIntervalGoesOverNewYear) {
    const WeightedInterval winter{.first = December / 1, .last = month_day(February, day(29)), .weight = -1};
    EXPECT_TRUE(winter.holds(2026y / December / 31, 0h));
    EXPECT_TRUE(winter.holds(2026y / February / 28, 0h));
    EXPECT_FALSE(winter.holds(2026y / March / 1, 0h));
}

TEST(TimeWeights, AWinterThatWantsShadeIsWarnedOf) {
    const TimeWeights northern = makeMonthlyWeights();
    EXPECT_FALSE(findSeasonMismatch(northern, 40.7));
    EXPECT_FALSE(findSeasonMismatch(northern, -1.3));  // Nairobi has no winter
    const auto melbourne = findSeasonMismatch(northern, -37.8);
    ASSERT_TRUE(melbourne);
    EXPECT_THAT(melbourne->what, HasSubstr("June to August, the winter"));
    TimeWeights southern = northern;
    for (WeightedInterval& interval : southern.intervals) interval.weight = -interval.weight;
    EXPECT_FALSE(findSeasonMismatch(southern, -37.8));
    EXPECT_TRUE(findSeasonMismatch(southern, 52.5));
    EXPECT_FALSE(findSeasonMismatch({"whole year", {{.name = "all", .weight = 1}}}, -37.8));
}

TEST(TimeWeights, HoursGoOverMidnight) {
    const WeightedInterval night{.name = "night", .from = 22h, .to = 5h, .weight = 1};
    EXPECT_TRUE(validate(TimeWeights{"nights", {night}}));
    for (const auto time : {0h, 4h, 22h, 23h}) EXPECT_TRUE(night.holds(2026y / June / 1, time));
    for (const auto time : {5h, 12h, 21h}) EXPECT_FALSE(night.holds(2026y / June / 1, time));
    const WeightedInterval day{.name = "day", .from = 5h, .to = 22h, .weight = -1};
    EXPECT_TRUE(validate(TimeWeights{"both", {night, day}}));
    const WeightedInterval dawn{.name = "dawn", .from = 4h, .to = 6h, .weight = -1};
    EXPECT_FALSE(validate(TimeWeights{"twice", {night, dawn}}));
    EXPECT_FALSE(validate(TimeWeights{"twice", {dawn, night}}));
    const WeightedInterval late{.name = "late", .from = 23h, .to = 1h, .weight = -1};
    EXPECT_FALSE(validate(TimeWeights{"twice", {night, late}}));
}

TEST(TimePieces, HoldEveryStepOnce) {
    const Study study = studied(year());
    const auto zone = Zone::named("America/New_York").value();
    const auto pieces = splitIntoPieces(study.sun, zone, makeMonthlyWeights());
    ASSERT_EQ(pieces.size(), 12U);
    std::size_t steps = 0, days = 0;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        EXPECT_EQ(unsigned(pieces[i].month.month()), i + 1);
        EXPECT_EQ(pieces[i].interval, i);
        steps += pieces[i].sun.steps.size();
        days += pieces[i].sun.days.size();
    }
    EXPECT_EQ(steps, study.sun.steps.size());
    EXPECT_EQ(days, 365U);
}

TEST(Score, IsTheWeightedSumOfTheMonths) {
    const Score score = scored(year(), makeMonthlyWeights());
    ASSERT_EQ(score.months.size(), 12U);
    StudySettings june = year();
    june.period.start = 2026y / June / 1;
    june.period.days = 30;
    StudySettings january = year();
    january.period.days = 31;
    const double shadeM2 = studied(june).statistics.shadowAreaM2;
    const double shadowM2 = studied(january).statistics.shadowAreaM2;
    EXPECT_NEAR(score.months[5].shadowAreaM2, shadeM2, 1e-4 * shadeM2);
    EXPECT_NEAR(score.months[5].scoreM2, shadeM2, 1e-4 * shadeM2);
    EXPECT_NEAR(score.months[0].scoreM2, -shadowM2, 1e-4 * shadowM2);
    EXPECT_EQ(score.months[3].scoreM2, 0);
    double sum = 0;
    for (const MonthFigures& month : score.months) sum += month.scoreM2;
    EXPECT_NEAR(score.scoreM2, sum, 1e-6 * std::abs(sum));
    EXPECT_LT(score.scoreM2, 0);  // winter's shadows are longer
}

// A share of an interval's time counts again in each part of it; hours in shadow do not.
TEST(Score, WeightedShadeDoesNotDependOnHowTheTableIsCut) {
    StudySettings day = year();
    day.period.days = 1;
    day.period.stepMinutes = 10;
    const TimeWeights whole{"whole", {{.name = "day", .from = 8h, .to = 16h, .weight = 1}}};
    const TimeWeights cut{"cut",
                          {{.name = "morning", .from = 8h, .to = 12h, .weight = 1},
                           {.name = "afternoon", .from = 12h, .to = 16h, .weight = 1}}};
    const Score one = scored(day, whole), two = scored(day, cut);
    // One day of 8 h: shadow area = shaded minutes x cell area / sunlit minutes.
    const ShadowStatistics truth = studied(day).statistics;
    const double shadedM2h = truth.shadowAreaM2 * one.months.at(0).sunlitMinutes / 60;
    EXPECT_NEAR(one.weightedShadeM2h, shadedM2h, 1e-4 * shadedM2h);
    EXPECT_NEAR(two.weightedShadeM2h, one.weightedShadeM2h, 1e-6 * shadedM2h);
    EXPECT_NEAR(two.months.at(0).weightedShadeM2h, one.months.at(0).weightedShadeM2h, 1e-6 * shadedM2h);
    EXPECT_NEAR(two.intervals[0].weightedShadeM2h + two.intervals[1].weightedShadeM2h, two.weightedShadeM2h,
                1e-6 * shadedM2h);
    EXPECT_GT(two.scoreM2, 1.5 * one.scoreM2);  // the paper's score does
}

TEST(Score, OfHoursCountsThoseHoursOnly) {
    StudySettings day = year();
    day.period.days = 1;
    day.period.stepMinutes = 10;
    const TimeWeights mornings{"mornings", {{.name = "morning", .to = 12h, .weight = 1}}};
    const Score score = scored(day, mornings);
    StudySettings morning = day;
    morning.period.hours = 4;
    const Study truth = studied(morning);
    EXPECT_NEAR(score.scoreM2, truth.statistics.shadowAreaM2, 1e-4 * score.scoreM2);
    ASSERT_EQ(score.intervals.size(), 1U);
    EXPECT_NEAR(score.intervals[0].shadowAreaM2, score.scoreM2, 1e-9 * score.scoreM2);
    // The month contains the afternoon, too.
    EXPECT_NEAR(score.months[0].shadowAreaM2, studied(day).statistics.shadowAreaM2, 1e-4 * score.scoreM2);
    EXPECT_NEAR(score.months[0].scoreM2, score.scoreM2, 1e-9 * score.scoreM2);
}

// Few bins make the error visible. The sample has all cells, so that the errors are the whole differences.
TEST(Score, ItsErrorsAreHowFarItIsOffRays) {
    StudySettings settings = year();
    settings.period.stepMinutes = 20;
    settings.errorSample.receivers = ErrorSampleSettings::maxReceivers;
    const Score truth = scored(settings, makeMonthlyWeights());
    EXPECT_TRUE(truth.errors.empty()) << "rays computed it";
    settings.engine = "horizon";
    settings.engineSettings["bin"] = 2;
    const Score score = scored(settings, makeMonthlyWeights());
    double off = 0, largest = 0, cells = 0;
    for (std::size_t i = 0; i < score.score.size(); ++i) {
        if (std::isnan(score.score[i])) continue;
        const double one = std::abs(double(score.score[i]) - double(truth.score[i]));
        off += one, largest = std::max(largest, one), ++cells;
    }
    ASSERT_EQ(score.errors.size(), 9U);
    EXPECT_GT(largest, 0);
    EXPECT_EQ(score.errors[0].facts.key, "cell_score");
    EXPECT_NEAR(score.errors[0].mean, off / cells, 0.1 * off / cells);
    EXPECT_NEAR(score.errors[0].largest, largest, 1e-5);
    EXPECT_EQ(score.errors[1].facts.key, "score_m2");
    EXPECT_LT(std::abs(score.scoreM2 - truth.scoreM2), score.errors[1].p99);
    EXPECT_EQ(score.errors[2].facts.key, "weighted_shade_m2h");
    EXPECT_LT(std::abs(score.weightedShadeM2h - truth.weightedShadeM2h), score.errors[2].p99);
    settings.errorSample.receivers = 0;
    EXPECT_TRUE(scored(settings, makeMonthlyWeights()).errors.empty());
}

TEST(Score, MonthsAndIntervalsLieWithinErrorsOfTheirOwn) {
    StudySettings settings = year();
    settings.period.stepMinutes = 20;
    settings.errorSample.receivers = ErrorSampleSettings::maxReceivers;
    const Score truth = scored(settings, makeMonthlyWeights());
    settings.engine = "horizon";
    settings.engineSettings["bin"] = 2;
    const Score score = scored(settings, makeMonthlyWeights());
    const auto expectWithin = [&](std::string_view key, const auto& parts, const auto& truths, auto member) {
        const auto error =
            std::ranges::find_if(score.errors, [&](const ShownError& one) { return one.facts.key == key; });
        ASSERT_NE(error, score.errors.end()) << key;
        ASSERT_EQ(parts.size(), truths.size());
        double off = 0;
        for (std::size_t i = 0; i < parts.size(); ++i)
            off = std::fmax(off, std::abs(parts[i].*member - truths[i].*member));
        EXPECT_GT(off, 0) << key;
        EXPECT_LT(off, error->p99) << key;
        EXPECT_LE(error->mean, error->p99) << key;
    };
    expectWithin("month_score_m2", score.months, truth.months, &MonthFigures::scoreM2);
    expectWithin("month_shadow_m2", score.months, truth.months, &MonthFigures::shadowAreaM2);
    expectWithin("month_shade_m2h", score.months, truth.months, &MonthFigures::weightedShadeM2h);
    expectWithin("interval_score_m2", score.intervals, truth.intervals, &IntervalFigures::scoreM2);
    expectWithin("interval_shadow_m2", score.intervals, truth.intervals, &IntervalFigures::shadowAreaM2);
    expectWithin("interval_shade_m2h", score.intervals, truth.intervals, &IntervalFigures::weightedShadeM2h);
}

TEST(Score, AnIntervalOverSeveralMonthsIsOneFraction) {
    StudySettings days = year();
    days.period.start = 2026y / May / 20;
    days.period.days = 30;
    const TimeWeights all{"all", {{.name = "all", .weight = 1}}};
    const Score score = scored(days, all);
    EXPECT_EQ(score.months.size(), 2U);
    EXPECT_NEAR(score.scoreM2, studied(days).statistics.shadowAreaM2, 1e-4 * score.scoreM2);
}

// The horizon sweep as an engine that cannot process step sets: it runs once for every month.
class PlainSweep final : public Engine {
public:
    [[nodiscard]] std::string_view name() const override { return "PlainSweep"; }
    [[nodiscard]] EngineCapabilities capabilities() const override {
        return {.terrain = true, .roofs = true};
    }

protected:
    Result<ShadowField> compute(const City& city, const Receivers& receivers, const SunSteps& sun,
                                Progress& progress, std::stop_token stop) const override {
        return HorizonSweep().accumulate(city, receivers, sun, progress, std::move(stop));
    }
};

Score scoredBy(const Engine& engine, const City& city, const StudySettings& settings) {
    const Receivers receivers = placeReceiversOnGround(city, settings.region, settings.receivers).value();
    const SunSteps sun = computeSunSteps(settings.period, makeObserver(city, settings), {}).value();
    const Zone zone = Zone::named(settings.period.zone).value();
    NoProgress progress;
    return computeScore(city, receivers, sun, zone, makeMonthlyWeights(), engine, progress, {}).value();
}

void expectAlike(const Score& made, const Score& plain, double share) {
    ASSERT_EQ(made.months.size(), plain.months.size());
    for (std::size_t i = 0; i < made.months.size(); ++i) {
        EXPECT_EQ(made.months[i].sunlitMinutes, plain.months[i].sunlitMinutes);
        EXPECT_NEAR(made.months[i].shadowAreaM2, plain.months[i].shadowAreaM2, share * made.receiverAreaM2);
        EXPECT_NEAR(made.months[i].scoreM2, plain.months[i].scoreM2, share * made.receiverAreaM2);
    }
    ASSERT_EQ(made.intervals.size(), plain.intervals.size());
    for (std::size_t i = 0; i < made.intervals.size(); ++i)
        EXPECT_NEAR(made.intervals[i].scoreM2, plain.intervals[i].scoreM2, share * made.receiverAreaM2);
}

TEST(Score, OneSweepForAllMonthsIsASweepForEach) {
    StudySettings settings = year();
    settings.receivers.cellM = 2;
    settings.period.stepMinutes = 5;
    const Score one = scoredBy(HorizonSweep(), threeHouses(), settings);
    EXPECT_THAT(one.engine, HasSubstr("one sweep for all months"));
    expectAlike(one, scoredBy(PlainSweep(), threeHouses(), settings), 5e-4);
    expectAlike(one, scoredBy(ProjectedShadows(), threeHouses(), settings), 5e-4);
}

class PlainProjection final : public Engine {
public:
    [[nodiscard]] std::string_view name() const override { return "PlainProjection"; }
    [[nodiscard]] EngineCapabilities capabilities() const override {
        return {.terrain = true, .roofs = true};
    }

protected:
    Result<ShadowField> compute(const City& city, const Receivers& receivers, const SunSteps& sun,
                                Progress& progress, std::stop_token stop) const override {
        return ProjectedShadows().accumulate(city, receivers, sun, progress, std::move(stop));
    }
};

TEST(Score, OneProjectionForAllPiecesIsOneForEach) {
    StudySettings settings = year();
    settings.period.days = 40;
    const Score one = scoredBy(ProjectedShadows(), threeHouses(), settings);
    EXPECT_THAT(one.engine, HasSubstr("one run for all months"));
    const Score plain = scoredBy(PlainProjection(), threeHouses(), settings);
    EXPECT_THAT(plain.engine, testing::Not(HasSubstr("one run")));
    expectAlike(one, plain, 1e-7);  // fields store rounded minutes a day
}

TEST(Score, OfOneMonthOneSweepIsTheSweepToTheLastBit) {
    StudySettings settings = year();
    settings.period.start = 2026y / June / 1;
    settings.period.days = 30;
    const Score one = scoredBy(HorizonSweep(), threeHouses(), settings);
    const Score plain = scoredBy(PlainSweep(), threeHouses(), settings);
    for (std::size_t i = 0; i < one.score.size(); ++i)
        ASSERT_TRUE(std::isnan(plain.score[i]) || std::abs(one.score[i] - plain.score[i]) < 1e-6F) << i;
    EXPECT_NEAR(one.scoreM2, plain.scoreM2, 1e-6 * plain.scoreM2);
}

TEST(Score, PartsThatHangAreInTheOneSweepToo) {
    City city = threeHouses();
    city.buildings.push_back(shared(house("bridge", box(10, 20, 30, 26), 12, 8)));
    Building bridge = *city.buildings.back();
    bridge.parts[0].isOverhanging = true;
    city.buildings.back() = shared(bridge);
    StudySettings settings = year();
    settings.period.days = 40;
    const Score made = scoredBy(HorizonSweep(), city, settings);
    EXPECT_THAT(made.engine, HasSubstr("one sweep"));
    expectAlike(made, scoredBy(PlainSweep(), city, settings), 5e-4);
}

TEST(Score, TheEngineAutoIsAskedOnceForTheWholePeriod) {
    StudySettings settings = year();
    settings.engine = "auto";
    const Score made = scored(settings, makeMonthlyWeights());
    EXPECT_THAT(made.engine, HasSubstr("chosen: projected shadows"));
    expectAlike(made, scored(year(), makeMonthlyWeights()), 1e-4);
    settings.period.stepMinutes = 1;  // for one month alone projected shadows would take less than 2 s
    settings.region = makeRegionFromLocalBox({{-20, -20}, {-18, 100}});
    settings.receivers.cellM = 0.5;
    EXPECT_THAT(scored(settings, makeMonthlyWeights()).engine,
                AllOf(HasSubstr("one sweep for all months"), HasSubstr("since the period is long")));
}

// A lime among the buildings, bare before day 100.
City townWithLime() {
    City town = threeHouses();
    Tree lime = completeTree(
        {.sourceId = "lime", .species = "Tilia", .heightM = 12.0, .crownDiameterM = 8.0, .crownBaseM = 3.0});
    lime.place = {40, -15};
    town.trees = std::make_shared<const Trees>(Trees{.trees = {lime}, .leafDays = {100, 300}});
    return town;
}

// A year that weighs 1 throughout scores its shadow area, and its weighted shade is area x hours.
TEST(Score, WithTreesOfEqualWeightsIsTheShadowAreaWithTrees) {
    const TimeWeights all{"all", {{.name = "year", .weight = 1}}};
    StudySettings settings = year();
    settings.errorSample.receivers = 0;
    settings.period.days = 120;
    NoProgress progress;
    for (const char* engine : {"ray", "horizon"}) {
        settings.engine = engine;
        const Score score = runScore(townWithLime(), settings, all, progress, {}).value();
        const Study study = runStudy(townWithLime(), settings, progress, {}).value();
        ASSERT_EQ(score.withTrees.size(), 2U) << engine;
        EXPECT_GT(score.withTrees[0].scoreM2, score.withTrees[1].scoreM2) << "evergreens first";
        EXPECT_GT(score.withTrees[1].scoreM2, score.scoreM2);
        for (const ShadedScore& with : score.withTrees) {
            const double areaM2 = computeStatistics(fieldOfColumn(study.field, with.column)).shadowAreaM2;
            // The sweep weighs the crowns of the study, rays those of the months.
            EXPECT_NEAR(with.scoreM2, areaM2, (settings.engine == "ray" ? 2e-4 : 0.01) * areaM2) << engine;
            EXPECT_NEAR(with.weightedShadeM2h, with.scoreM2 * study.sun.sunlitMinutes() / 60,
                        1e-6 * with.weightedShadeM2h);
            ASSERT_EQ(with.months.size(), 4U);
            double sum = 0;
            for (const MonthFigures& month : with.months) sum += month.scoreM2;
            EXPECT_NEAR(sum, with.scoreM2, 1e-9 * areaM2);
        }
        // Leaves are on from day 100, 10 April.
        EXPECT_GT(score.withTrees[0].months[0].shadowAreaM2, score.withTrees[1].months[0].shadowAreaM2);
        EXPECT_THAT(score.warnings, testing::IsEmpty());
    }
}

TEST(Score, FilesAndSavedResultsStateTheColumnsOfTrees) {
    StudySettings settings = year();
    settings.errorSample.receivers = 0;
    settings.period.days = 3;
    NoProgress progress;
    ScoreAnswer answer{.settings = settings, .weights = makeMonthlyWeights()};
    answer.score = runScore(townWithLime(), settings, answer.weights, progress, {}).value();
    ASSERT_EQ(answer.score.withTrees.size(), 2U);
    const auto json = nlohmann::ordered_json::parse(scoreJson(answer));
    EXPECT_EQ(json.at("score_m2_evergreen"), answer.score.withTrees[0].scoreM2);
    EXPECT_EQ(json.at("months").at(0).at("shadow_area_m2_seasonal"),
              answer.score.withTrees[1].months[0].shadowAreaM2);
    EXPECT_FALSE(json.at("intervals").at(0).contains("weight_evergreen"));
    EXPECT_TRUE(json.at("definitions").contains("score_m2_seasonal"));
    EXPECT_THAT(scoreCsv(answer), HasSubstr(",score_m2,weighted_shade_m2h_evergreen,"));
    const Score read = parseScore(json);
    ASSERT_EQ(read.withTrees.size(), 2U);
    EXPECT_EQ(read.withTrees[1].column, TreeColumns::seasonal);
    EXPECT_EQ(read.withTrees[1].scoreM2, answer.score.withTrees[1].scoreM2);
    EXPECT_EQ(read.withTrees[0].intervals[0].scoreM2, answer.score.withTrees[0].intervals[0].scoreM2);
    EXPECT_EQ(read.withTrees[0].months[0].sunlitMinutes, answer.score.months[0].sunlitMinutes);

    const auto all = std::make_shared<const Score>(answer.score);
    const auto shown = showColumn(all, TreeColumns::seasonal);
    EXPECT_EQ(shown->scoreM2, answer.score.withTrees[1].scoreM2);
    EXPECT_THAT(shown->score,
                testing::Pointwise(testing::NanSensitiveFloatEq(), answer.score.withTrees[1].score));
    EXPECT_EQ(shown->intervals[0].scoreM2, answer.score.withTrees[1].intervals[0].scoreM2);
    EXPECT_THAT(shown->withTrees, testing::IsEmpty());
    EXPECT_EQ(showColumn(all, TreeColumns::without), all);

    settings.trees = TreeColumns::seasonal;
    const Score one = runScore(townWithLime(), settings, answer.weights, progress, {}).value();
    ASSERT_EQ(one.withTrees.size(), 1U);
    EXPECT_EQ(one.withTrees[0].column, TreeColumns::seasonal);
    settings.trees = TreeColumns::without;
    EXPECT_THAT(runScore(townWithLime(), settings, answer.weights, progress, {})->withTrees,
                testing::IsEmpty());
}

}  // namespace
}  // namespace noonmark::tests
