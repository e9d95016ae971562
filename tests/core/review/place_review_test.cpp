#include "core/review/places/place_review.h"

#include <gmock/gmock.h>

#include <random>

#include "core/review/library/rule_library.h"
#include "core/review/places/review_columns.h"
#include "core/review/places/verdict_text.h"
#include "tests/core/review/paper_days.h"

namespace noonmark {

namespace {

using enum Verdict;

/// The rule `own` with one criterion.
Rule ruleWith(const Criterion& criterion) {
    Rule rule = shippedRule("own");
    rule.criteria = {criterion};
    return rule;
}

Criterion criterionOf(Quantity quantity, Measure measure, Comparison comparison, double limit) {
    Criterion criterion;
    criterion.key = criterion.name = "test";
    criterion.quantity = quantity;
    criterion.measure = measure;
    criterion.limits = {{comparison, limit, false, {}}};
    return criterion;
}

/// Days of one criterion on a place of two cells, of which one is in shadow for so many of 200 minutes.
PlaceReview daysOf(const Rule& rule, const std::vector<int>& minutes,
                   const std::vector<double>& weights = {}) {
    const DayClock clock = utcClock();
    PlaceEvaluation evaluation(rule, clock, "Green", PlaceKind::park);
    for (std::size_t i = 0; i < minutes.size(); ++i) {
        const PaperDay day(on(2026, 3, unsigned(1 + i)), 480, 1, times(2, lit(200)),
                           {lit(200), shaded(minutes[i]) + lit(200 - minutes[i])});
        evaluation.add(day.shadow, weights.empty() ? 1 : weights[i]);
    }
    return evaluation.finish();
}

TEST(PlaceReview, CombinesDaysAsTheRuleWants) {
    Criterion criterion = criterionOf(Quantity::incremental, Measure::spotTotal, Comparison::atMost, 60);
    const std::vector<int> days{20, 100, 30};
    criterion.combination = DayCombination::every;
    PlaceReview review = daysOf(ruleWith(criterion), days);
    EXPECT_EQ(review.verdict, fail);
    EXPECT_EQ(review.results[0].day, on(2026, 3, 2));
    EXPECT_EQ(review.results[0].failingDays, 1);
    EXPECT_THAT(describeReason(review), testing::HasSubstr("1 h 40 min on 2026-03-02, wanted <= 1 h"));
    criterion.combination = DayCombination::chosen;
    review = daysOf(ruleWith(criterion), days);
    EXPECT_EQ(review.verdict, pass);
    EXPECT_EQ(review.results[0].day, on(2026, 3, 1));
    criterion.combination = DayCombination::average;  // (20 + 100 + 30) / 3 = 50
    review = daysOf(ruleWith(criterion), days);
    EXPECT_EQ(review.verdict, pass);
    EXPECT_DOUBLE_EQ(review.results[0].value->value, 50);
    // Weighted: (20 + 100 x 2 + 30) / 4 = 62.5, less than a minute and a half from 60 is not within one
    // minute.
    review = daysOf(ruleWith(criterion), days, {1, 2, 1});
    EXPECT_DOUBLE_EQ(review.results[0].value->value, 62.5);
    EXPECT_EQ(review.verdict, fail);
    criterion.combination = DayCombination::sum;
    review = daysOf(ruleWith(criterion), days, {1, 2, 1});
    EXPECT_DOUBLE_EQ(review.results[0].value->value, 250);
}

TEST(PlaceReview, LeavesDaysOutOfSeasonOut) {
    Criterion criterion = criterionOf(Quantity::incremental, Measure::spotTotal, Comparison::atMost, 60);
    criterion.season.emplace(std::chrono::March / 2, std::chrono::March / 3);
    const PlaceReview review = daysOf(ruleWith(criterion), {100, 20, 20});
    EXPECT_EQ(review.verdict, pass);
    EXPECT_EQ(review.results[0].days, 2);
    EXPECT_FALSE(review.rows[0].criteria[0].has_value());
    criterion.season.emplace(std::chrono::November / 1, std::chrono::February / 28);
    EXPECT_EQ(daysOf(ruleWith(criterion), {100}).verdict, notApplicable);
}

TEST(PlaceReview, AnAdvisoryCriterionDoesNotDecide) {
    Criterion criterion = criterionOf(Quantity::incremental, Measure::spotTotal, Comparison::atMost, 60);
    criterion.advisory = true;
    const PlaceReview review = daysOf(ruleWith(criterion), {100});
    EXPECT_EQ(review.verdict, notApplicable);
    EXPECT_EQ(review.results[0].verdict, fail);
}

TEST(PlaceReview, SumsTheLongestRunsAndDropsShortOnes) {
    // Runs of 4, 50, 30, 3 and 40 minutes of shadow.
    std::string cell;
    for (const int run : {4, 50, 30, 3, 40}) cell += lit(5) + shaded(run);
    cell += lit(5);
    const auto valueOf = [&](Measure measure, int runs, double drop) {
        Criterion criterion = criterionOf(Quantity::shadow, measure, Comparison::atMost, 1000);
        criterion.runs = runs;
        criterion.dropShorterMin = drop;
        return reviewOf(ruleWith(criterion), {lit(int(cell.size()))}, {cell}).results[0].value->value;
    };
    EXPECT_DOUBLE_EQ(valueOf(Measure::spotTotal, 1, 0), 127);
    EXPECT_DOUBLE_EQ(valueOf(Measure::spotTotal, 1, 4), 124);
    EXPECT_DOUBLE_EQ(valueOf(Measure::spotTotal, 1, 5), 120);
    EXPECT_DOUBLE_EQ(valueOf(Measure::spotLongestRun, 1, 0), 50);
    EXPECT_DOUBLE_EQ(valueOf(Measure::spotLongestRuns, 2, 0), 90);
    EXPECT_DOUBLE_EQ(valueOf(Measure::spotLongestRuns, 3, 0), 120);
    EXPECT_DOUBLE_EQ(valueOf(Measure::spotLongestRuns, 8, 0), 127);
    EXPECT_DOUBLE_EQ(valueOf(Measure::spotLongestRuns, 8, 5), 120);
}

TEST(PlaceReview, AGapBetweenSlotsEndsARun) {
    const DayClock clock = utcClock();
    const Rule rule =
        ruleWith(criterionOf(Quantity::shadow, Measure::spotLongestRun, Comparison::atMost, 100));
    PaperDay day(on(2026, 3, 21), 480, 1, {lit(60)}, {shaded(60)});
    for (std::size_t i = 20; i < 60; ++i) day.steps[i].slot += 5;
    PlaceEvaluation evaluation(rule, clock, "Green", PlaceKind::park);
    evaluation.add(day.shadow);
    const PlaceReview review = evaluation.finish();
    EXPECT_DOUBLE_EQ(review.results[0].value->value, 40);
    EXPECT_EQ(review.rows[0].intervals, 2);
    EXPECT_DOUBLE_EQ(review.rows[0].durationMin, 60);
}

// Two hours of sun on a quarter of the area: less than the half that is wanted, but as much as before.
TEST(PlaceReview, ACityWithoutAProposalIsNotComparedWithItself) {
    Criterion criterion = criterionOf(Quantity::sun, Measure::spotTotal, Comparison::atLeast, 120);
    criterion.key = "sun";
    criterion.limits.push_back({Comparison::atLeast, 0.8, true, false, {}});
    Criterion loss = criterionOf(Quantity::sun, Measure::spotTotal, Comparison::atLeast, 0.8);
    loss.key = "loss";
    loss.limits[0].ofFormer = true;
    Rule rule = ruleWith(criterion);
    rule.criteria.push_back(loss);
    const Cells cells{lit(60) + shaded(120)};
    EXPECT_EQ(reviewOf(rule, cells, cells).verdict, Verdict::pass);
    const Rule alone = dropComparisons(rule);
    const PlaceReview review = reviewOf(alone, cells, cells);
    EXPECT_EQ(review.verdict, Verdict::fail);
    EXPECT_EQ(review.results[1].verdict, Verdict::notApplicable) << "stated only";
    EXPECT_EQ(alone.readings.size(), rule.readings.size() + 1);
}

// The cell's centre is in shadow from minute 10 to 40; a point between centres from 5 to 45, another from 60.
TEST(PlaceReview, TimesAndDurationAreThoseOfAnyPointOfThePlace) {
    const DayClock clock = utcClock();
    const Rule rule =
        ruleWith(criterionOf(Quantity::incremental, Measure::spotTotal, Comparison::atMost, 100));
    const PaperDay centre(on(2026, 3, 21), 480, 1, {lit(90)}, {lit(10) + shaded(30) + lit(50)});
    const PaperDay between(on(2026, 3, 21), 480, 1, times(2, lit(90)),
                           {lit(5) + shaded(40) + lit(45), lit(60) + shaded(20) + lit(10)});
    PlaceEvaluation evaluation(rule, clock, "Green", PlaceKind::park);
    evaluation.add(centre.shadow, 1, std::vector{between.shadow});
    const ReviewRow row = evaluation.finish().rows[0];
    EXPECT_EQ(row.entersText, "08:05");
    EXPECT_EQ(row.exitsText, "09:20");
    EXPECT_EQ(row.intervals, 2);
    EXPECT_DOUBLE_EQ(row.durationMin, 60);
    EXPECT_DOUBLE_EQ(row.maxPointMin, 40);
    EXPECT_DOUBLE_EQ(row.maxAreaM2, 1) << "points have no area";
    EXPECT_DOUBLE_EQ(row.incrementalM2h, 0.5);
}

TEST(PlaceReview, RunsOfManyCellsEqualThoseCountedOneByOne) {
    std::mt19937 random(7);
    Cells before(150), after(150);
    for (std::size_t cell = 0; cell < 150; ++cell)
        for (int step = 0; step < 97; ++step) {
            before[cell] += random() % 3 == 0 ? '#' : '.';
            after[cell] += random() % 2 == 0 ? '#' : '.';
        }
    const PaperDay day(on(2026, 3, 21), 480, 1, before, after);
    for (const Quantity quantity : {Quantity::shadow, Quantity::incremental, Quantity::sun})
        for (const bool former : {false, true}) {
            const SpotRuns runs = countRuns(day.shadow, quantity, former, {2, 2});
            for (std::size_t cell = 0; cell < 150; ++cell) {
                std::vector<unsigned> lengths;
                unsigned length = 0;
                for (std::size_t step = 0; step <= 97; ++step) {
                    const bool dark = step < 97 && (former ? before : after)[cell][step] == '#';
                    const bool darkBefore = step < 97 && before[cell][step] == '#';
                    const bool has =
                        step < 97 && (quantity == Quantity::shadow ? dark
                                      : quantity == Quantity::sun  ? !dark
                                                                   : !former && dark && !darkBefore);
                    if (has) {
                        ++length;
                    } else {
                        if (length >= 2) lengths.push_back(length);
                        length = 0;
                    }
                }
                std::ranges::sort(lengths, std::greater{});
                unsigned total = 0, two = 0;
                for (std::size_t i = 0; i < lengths.size(); ++i) {
                    total += lengths[i];
                    two += i < 2 ? lengths[i] : 0;
                }
                ASSERT_EQ(runs.total[cell], total);
                ASSERT_EQ(runs.count[cell], lengths.size());
                ASSERT_EQ(runs.longest[cell], lengths.empty() ? 0 : lengths[0]);
                ASSERT_EQ(runs.longestRuns[cell], two);
            }
        }
}

TEST(PlaceReview, StatesWhyThereIsNoVerdict) {
    const Rule rule = shippedRule("own");
    const DayClock clock = utcClock();
    PlaceEvaluation night(rule, clock, "Green", PlaceKind::park);
    PaperDay day(on(2026, 12, 21), 480, 1, {lit(1)}, {lit(1)});
    day.shadow.steps = {};
    day.shadow.baseline = day.shadow.scenario = StepMasks(1, 0);
    night.add(day.shadow);
    EXPECT_EQ(night.finish().verdict, notChecked);
    PlaceEvaluation built(rule, clock, "Green", PlaceKind::park);
    PaperDay noCells(on(2026, 12, 21), 480, 1, {lit(1)}, {lit(1)});
    noCells.shadow.baseline = noCells.shadow.scenario = StepMasks(0, 1);
    built.add(noCells.shadow);
    EXPECT_EQ(built.finish().verdict, notChecked);
    EXPECT_THAT(built.finish().results, testing::Each(testing::Field(&CriterionResult::verdict, notChecked)));
    Rule windows = rule;
    windows.receivers.surface = RuleSurface::windows;
    EXPECT_EQ(verdictOf(windows, {lit(9)}, {lit(9)}), notApplicable);
}

TEST(PlaceReview, MeasuresAreasAndSharesOfThePlace) {
    // Four cells of 25 m2: two in shadow in the baseline throughout; the tower shades a third for 6 of 12
    // min.
    const Cells before{shaded(12), shaded(12), lit(12), lit(12)};
    const Cells after{shaded(12), shaded(12), shaded(6) + lit(6), lit(12)};
    const auto valueOf = [&](Quantity quantity, Measure measure) {
        const Criterion criterion = criterionOf(quantity, measure, Comparison::atMost, 1);
        return reviewOf(ruleWith(criterion), before, after, {.cellM2 = 25}).results[0].value->value;
    };
    EXPECT_DOUBLE_EQ(valueOf(Quantity::shadow, Measure::largestArea), 75);
    EXPECT_DOUBLE_EQ(valueOf(Quantity::incremental, Measure::largestArea), 25);
    EXPECT_DOUBLE_EQ(valueOf(Quantity::incremental, Measure::largestShare), 0.25);
    EXPECT_DOUBLE_EQ(valueOf(Quantity::sun, Measure::largestArea), 50);
    EXPECT_DOUBLE_EQ(valueOf(Quantity::incremental, Measure::areaHours), 25 * 6 / 60.0);
    EXPECT_DOUBLE_EQ(valueOf(Quantity::shadow, Measure::areaHours), (50 * 12 + 25 * 6) / 60.0);
    EXPECT_DOUBLE_EQ(valueOf(Quantity::incremental, Measure::span), 6);
    EXPECT_DOUBLE_EQ(valueOf(Quantity::incremental, Measure::anywhere), 6);
    EXPECT_DOUBLE_EQ(valueOf(Quantity::sun, Measure::spotTotal), 0);
}

TEST(ReviewColumns, WriteNumbersAndTimes) {
    const PlaceReview review = reviewOf(shippedRule("own"), times(2, lit(90)),
                                        {lit(90), lit(10) + shaded(75) + lit(5)}, {.cellM2 = 100});
    const ReviewRow& row = review.rows.at(0);
    EXPECT_EQ(columnText(review, row, "day"), "2026-03-21");
    EXPECT_EQ(columnText(review, row, "enters"), "08:10");
    EXPECT_EQ(columnText(review, row, "duration_min"), "75");
    EXPECT_EQ(columnText(review, row, "duration_hm"), "1:15");
    EXPECT_EQ(columnText(review, row, "max_area_ft2"), "1,076");
    EXPECT_EQ(columnText(review, row, "max_share"), "50.0 %");
    EXPECT_EQ(columnText(review, row, "incremental_m2h"), "125");
    EXPECT_EQ(columnText(review, row, "criterion.new-shadow"), "75");
    EXPECT_EQ(columnText(review, row, "criterion.none"), "-");
    const PlaceReview calm = reviewOf(shippedRule("own"), times(2, lit(9)), times(2, lit(9)));
    EXPECT_EQ(columnText(calm, calm.rows.at(0), "enters"), "-");
}

TEST(Verdicts, ARangeAroundTheLimitIsBorderline) {
    EXPECT_EQ(compareWith(Comparison::atLeast, 120, {120, 120, 120}), borderline);
    EXPECT_EQ(compareWith(Comparison::atMost, 120, {119, 118, 120}), borderline);
    EXPECT_EQ(compareWith(Comparison::below, 120, {118, 117, 119}), pass);
    EXPECT_EQ(compareWith(Comparison::above, 120, {118, 117, 119}), fail);
    EXPECT_EQ(compareWith(Comparison::atMost, 0, {0, 0, 0}), pass) << "no shadow at any step";
    EXPECT_EQ(compareWith(Comparison::atLeast, 1, {1, 1, 1}), pass) << "no spot is short of it";
    EXPECT_EQ(ratioOf({0, 0, 0}, {0, 0, 0}).value, 1);
}

TEST(ReviewColumns, TitlesOfRulesWriteUnitsAsPeopleDo) {
    const auto library = RuleLibrary::load({});
    ASSERT_TRUE(library);
    for (const Rule& rule : library->rules())
        for (const RuleColumn& column : rule.deliverables.columns)
            for (const char* unit : {"m2", "ft2"})
                EXPECT_EQ(column.title.find(unit), std::string::npos) << rule.key << ": " << column.title;
}

TEST(ReviewColumns, SquareMetresAreShownInTheUnitsOfTheProject) {
    const std::vector<RuleColumn> columns{
        {"Day", "day"},           {"Largest area, m2", "max_area_m2"},  {"All shadow, m2 h", "scenario_m2h"},
        {"Gained", "gained_m2h"}, {"Existing, ft2 h", "baseline_ft2h"}, {"Existing, m2 h", "baseline_m2h"}};
    const auto shown = [&](UnitSystem units) {
        std::string text;
        for (const RuleColumn& column : columnsIn(units, columns))
            text += column.title + "|" + column.key + "\n";
        return text;
    };
    EXPECT_EQ(shown(UnitSystem::imperial),
              "Day|day\nLargest area, sq ft|max_area_ft2\nAll shadow, sq ft h|scenario_ft2h\n"
              "Gained, sq ft h|gained_ft2h\nExisting, ft2 h|baseline_ft2h\n");
    EXPECT_EQ(columnsIn(UnitSystem::metric, columns).size(), columns.size());
    EXPECT_EQ(columnsIn(UnitSystem::both, columns).size(), columns.size() + 3);  // baseline_ft2h is there
    for (const RuleColumn& column : columnsIn(UnitSystem::both, columns))
        EXPECT_TRUE(isReviewColumn(Rule{}, column.key)) << column.key;
}

}  // namespace

}  // namespace noonmark
