// For each rule that ships: cases worked out by hand that pass, fail and lie at the threshold.

#include <gmock/gmock.h>

#include "tests/core/review/paper_days.h"

namespace noonmark {

namespace {

using enum Verdict;

TEST(CeqrRule, FailsWhereAllSunIsGoneForMoreThanTenMinutes) {
    const Rule rule = shippedRule("ceqr");
    // Four cells, lit in the baseline for an hour of minutes. The tower covers all of them for n minutes,
    // known to a minute: n + 1 < 10 passes, n - 1 > 10 fails.
    const auto verdict = [&](int n) {
        return verdictOf(rule, times(4, lit(60)), times(4, lit(20) + shaded(n) + lit(40 - n)));
    };
    EXPECT_EQ(verdict(0), pass);
    EXPECT_EQ(verdict(8), pass);
    EXPECT_EQ(verdict(9), borderline);
    EXPECT_EQ(verdict(10), borderline);
    EXPECT_EQ(verdict(11), borderline);
    EXPECT_EQ(verdict(12), fail);
}

TEST(CeqrRule, CountsFullCoverOfWhatTheBaselineLeavesLit) {
    const Rule rule = shippedRule("ceqr");
    // The baseline shades two of four cells all the time; the tower covers the other two for 20 minutes.
    const Cells before = times(2, shaded(60)) + times(2, lit(60));
    const Cells after = times(2, shaded(60)) + times(2, lit(20) + shaded(20) + lit(20));
    const PlaceReview review = reviewOf(rule, before, after);
    EXPECT_EQ(review.verdict, fail);
    EXPECT_DOUBLE_EQ(review.rows[0].fullCoverMin, 20);
    // In full shadow of the baseline there is no sun to eliminate.
    EXPECT_EQ(verdictOf(rule, times(4, shaded(60)), times(4, shaded(60))), pass);
}

TEST(CeqrRule, StatesEntersExitsAndTheWorstSpot) {
    // From 8:00 on: cell 1 is shaded from 8:05 to 8:15, cell 2 from 8:10 to 8:30, cell 3 never. On the place
    // shadow enters at 8:05 and exits at 8:30: 25 min. One spot has 20 min at most. Two cells of 2 m2 at
    // once.
    const Cells before = times(3, lit(60));
    const Cells after{lit(5) + shaded(10) + lit(45), lit(10) + shaded(20) + lit(30), lit(60)};
    const PlaceReview review = reviewOf(shippedRule("ceqr"), before, after, {.cellM2 = 2});
    const ReviewRow& row = review.rows.at(0);
    EXPECT_EQ(row.entersText, "08:05");
    EXPECT_EQ(row.exitsText, "08:30");
    EXPECT_DOUBLE_EQ(row.durationMin, 25);
    EXPECT_EQ(row.intervals, 1);
    EXPECT_DOUBLE_EQ(row.maxAreaM2, 4);
    EXPECT_EQ(row.maxAtText, "08:10");
    EXPECT_DOUBLE_EQ(row.maxPointMin, 20);
    EXPECT_DOUBLE_EQ(row.fullCoverMin, 0);
    EXPECT_DOUBLE_EQ(row.incrementalM2h, (10 + 20) * 2 / 60.0);
    EXPECT_EQ(review.verdict, pass);
}

TEST(CeqrRule, DoesNotApplyToStreets) {
    const Cells none = times(2, lit(10));
    EXPECT_EQ(verdictOf(shippedRule("ceqr"), none, none, {.kind = PlaceKind::street}), notApplicable);
}

TEST(SanFranciscoRule, SumsAreaHoursAndTheirShareOfTheTheoreticalSum) {
    const Rule rule = shippedRule("san-francisco-295");
    // Two cells of 4 m2, four steps of 15 min. Baseline: cell 1 shaded in the first step: 4 m2 x 0.25 h = 1
    // m2 h. With the project: cell 1 in the first, cell 2 in the last two: 1 + 2 = 3 m2 h, of which 2 are
    // new.
    const DayClock clock = utcClock();
    PlaceEvaluation evaluation(rule, clock, "Square", PlaceKind::park);
    const PaperDay day(on(2026, 6, 21), 480, 15, {"#...", "...."}, {"#...", "..##"}, 4);
    evaluation.add(day.shadow, 2);
    const PlaceReview review = evaluation.finish();
    EXPECT_DOUBLE_EQ(review.totals.baselineM2h, 2 * 1.0);
    EXPECT_DOUBLE_EQ(review.totals.scenarioM2h, 2 * 3.0);
    EXPECT_DOUBLE_EQ(review.totals.incrementalM2h, 2 * 2.0);
    EXPECT_DOUBLE_EQ(review.totals.theoreticalM2h, 8 * 3721.4);
    EXPECT_EQ(review.totals.largestDay, on(2026, 6, 21));
    EXPECT_DOUBLE_EQ(review.totals.largestDayDurationMin, 30);
    EXPECT_DOUBLE_EQ(review.totals.incrementalByMonthM2h[5], 4);
    EXPECT_DOUBLE_EQ(review.results.at(0).value->value, 4);
    EXPECT_EQ(review.verdict, notApplicable) << "the figures at hand state no limit";
}

TEST(BostonCommonRule, AllowsNoNewShadowWithinItsHours) {
    const Rule rule = shippedRule("boston-common");
    const auto verdict = [&](int steps) {  // of 5 min
        return verdictOf(rule, times(3, lit(50)), Cells{lit(50), lit(50), shaded(steps) + lit(50 - steps)},
                         {.stepMin = 5});
    };
    EXPECT_EQ(verdict(0), pass);
    EXPECT_EQ(verdict(1), borderline) << "5 min, known to 5 min";
    EXPECT_EQ(verdict(2), fail);
    // Shadow on what was shaded before is not new.
    EXPECT_EQ(verdictOf(rule, times(3, shaded(50)), times(3, shaded(50)), {.stepMin = 5}), pass);
}

TEST(BostonMidtownRule, AllowsLessThanTwoHoursAtASpot) {
    const Rule rule = shippedRule("boston-midtown");
    const auto verdict = [&](int steps) {  // of 5 min, in one run: known to 5 min
        return verdictOf(rule, times(2, lit(78)), Cells{lit(78), shaded(steps) + lit(78 - steps)},
                         {.stepMin = 5});
    };
    EXPECT_EQ(verdict(22), pass);        // 110 + 5 < 120
    EXPECT_EQ(verdict(24), borderline);  // 120
    EXPECT_EQ(verdict(26), fail);        // 130 - 5 > 120
}

TEST(DiagramRules, GiveFiguresWithoutAVerdict) {
    for (const std::string key : {"boston-article-80", "toronto", "vancouver", "four-days"}) {
        // Two cells of 1 m2: shadow from 8:10 to 8:40 on one, 8:30 to 8:50 on both.
        const PlaceReview review = reviewOf(shippedRule(key), times(2, lit(60)),
                                            {lit(10) + shaded(30) + lit(20), lit(30) + shaded(20) + lit(10)});
        EXPECT_EQ(review.verdict, notApplicable) << key;
        EXPECT_EQ(review.rows.at(0).entersText, "08:10") << key;
        EXPECT_EQ(review.rows.at(0).exitsText, "08:50") << key;
        EXPECT_DOUBLE_EQ(review.rows.at(0).maxAreaM2, 2) << key;
        EXPECT_TRUE(shippedRule(key).deliverables.diagrams.has_value()) << key;
    }
}

TEST(MontrealParksRule, WantsEightUnbrokenHoursOnHalfTheArea) {
    const Rule rule = shippedRule("montreal-parks");
    // Ten hours of minutes. Ten cells; one cell more or less is within the error of the area.
    const std::string good = lit(500) + shaded(100), bad = lit(300) + shaded(10) + lit(290);
    const auto verdict = [&](int goodCells) {
        return verdictOf(rule, times(10, lit(600)), times(goodCells, good) + times(10 - goodCells, bad));
    };
    EXPECT_EQ(verdict(7), pass);        // 0.6 < share
    EXPECT_EQ(verdict(5), borderline);  // 0.5
    EXPECT_EQ(verdict(6), borderline);  // 0.5 at least: not above
    EXPECT_EQ(verdict(3), fail);        // share < 0.4
    // Exactly 480 min everywhere: each spot is within a minute of what it needs.
    EXPECT_EQ(verdictOf(rule, times(10, lit(600)), times(10, lit(480) + shaded(120))), borderline);
}

TEST(MontrealStreetsRule, WantsUnbrokenSunAtEverySpot) {
    const PaperPlace street{.kind = PlaceKind::street};
    const auto verdict = [&](const Rule& rule, int minutes) {
        return verdictOf(rule, times(2, lit(180)), {lit(180), lit(minutes) + shaded(180 - minutes)}, street);
    };
    const Rule rule = shippedRule("montreal-streets"),
               narrow = shippedRule("montreal-streets", {{"minutes", "90"}});
    EXPECT_EQ(verdict(rule, 152), pass);
    EXPECT_EQ(verdict(rule, 150), borderline);
    EXPECT_EQ(verdict(rule, 148), fail);
    EXPECT_EQ(verdict(narrow, 148), pass);
    EXPECT_EQ(verdict(narrow, 90), borderline);
    EXPECT_EQ(verdict(narrow, 80), fail);
    // 170 min of sun in two parts of 80 and 90 are not 150 unbroken.
    EXPECT_EQ(verdictOf(rule, times(1, lit(180)), {lit(80) + shaded(10) + lit(90)}, street), fail);
}

TEST(BreRule, WantsTwoHoursOnHalfTheSpaceOrFourFifthsOfTheFormer) {
    const Rule rule = shippedRule("bre-209-amenity");
    const std::string sunny = lit(60) + shaded(20) + lit(100),
                      dark = lit(100) + shaded(80);  // 160 and 100 min
    const auto cells = [&](int sunnyCells) {
        return times(sunnyCells, sunny) + times(100 - sunnyCells, dark);
    };
    const auto verdict = [&](int before, int after) { return verdictOf(rule, cells(before), cells(after)); };
    EXPECT_EQ(verdict(90, 60), pass);        // half and more
    EXPECT_EQ(verdict(90, 50), borderline);  // half
    EXPECT_EQ(verdict(90, 40), fail);        // 0.44 of the former
    EXPECT_EQ(verdict(30, 30), pass);        // not half, but as before
    EXPECT_EQ(verdict(40, 32), borderline);  // 0.8 x former
    EXPECT_EQ(verdict(40, 20), fail);
    const PlaceReview review = reviewOf(rule, cells(40), cells(32));
    EXPECT_DOUBLE_EQ(review.results.at(0).value->value, 0.32);
    EXPECT_DOUBLE_EQ(review.results.at(0).former->value, 0.4);
}

TEST(ZurichRule, AllowsThreeHoursOrAsMuchAsTheReferenceBodyAtTheSameSpot) {
    const Rule rule = shippedRule("zurich");
    EXPECT_EQ(rule.sampling.stepMinutes, 1);
    const auto spot = [](int minutes) { return shaded(minutes) + lit(540 - minutes); };  // of nine hours
    const auto verdict = [&](int before, int after) {
        return verdictOf(rule, times(4, spot(before)), times(4, spot(after)));
    };
    EXPECT_EQ(verdict(0, 178), pass);        // 178 + 1 < 180
    EXPECT_EQ(verdict(0, 179), borderline);  // within a step of 3 h
    EXPECT_EQ(verdict(0, 181), borderline);
    EXPECT_EQ(verdict(0, 182), fail);
    EXPECT_EQ(verdict(0, 130), pass) << "more than 2 h is not within a step of 3 h";
    EXPECT_EQ(verdict(300, 300), pass) << "the reference body casts the very same shadow";
    EXPECT_EQ(verdict(300, 299), pass);
    EXPECT_EQ(verdict(300, 302), borderline);  // each known to a minute
    EXPECT_EQ(verdict(300, 303), fail);
    // As much as the reference body at its worst spot, but elsewhere: four spots have gained what they
    // lacked.
    const PlaceReview moved = reviewOf(rule, times(4, spot(300)) + times(4, spot(0)),
                                       times(4, spot(0)) + times(4, spot(300)), {.cellM2 = 2});
    EXPECT_EQ(moved.verdict, fail);
    EXPECT_DOUBLE_EQ(moved.results.at(0).value->value, 8);
    EXPECT_DOUBLE_EQ(moved.results.at(1).value->value, 300);
}

// As in every area and share, a cell counts with its share of the place, wherever its centre lies.
TEST(ZurichRule, CountsTheCellsOnTheEdgeOfAPlaceWithTheirShare) {
    const PaperDay day(on(2026, 2, 8), 480, 1, times(4, lit(540)),
                       times(3, lit(540)) + times(1, shaded(200) + lit(340)));
    const std::vector<WeightedCell> uneven{{3, -0.7, true}};
    PlaceShadow shadow = day.shadow;
    shadow.uneven = uneven;
    const Measured over = measureDay(shippedRule("zurich").criteria.at(0), DayShadow(shadow, 0), false);
    EXPECT_NEAR(over.value, 0.3, 1e-12);
    EXPECT_EQ(over.low, 0) << "the edge of the shadow passes through the place there";
}

TEST(MelbourneRule, AllowsNoAddedShadow) {
    const Rule rule = shippedRule("melbourne-c278");
    const auto verdict = [&](int minutes) {
        return verdictOf(rule, times(2, lit(300)), {lit(300), shaded(minutes) + lit(300 - minutes)});
    };
    EXPECT_EQ(verdict(0), pass);
    EXPECT_EQ(verdict(1), borderline);
    EXPECT_EQ(verdict(2), fail);
    EXPECT_EQ(shippedRule("melbourne-c278", {{"park type", "3"}}).window.hours.to.at(0).minutes, 14 * 60);
}

TEST(JapanRule, ComparesEachBeltWithItsLimit) {
    struct Zone {
        std::string name;
        int inner, outer;
    };
    for (const Zone& zone : {Zone{"3 h, 2 h", 180, 120},
                             {"4 h, 2.5 h", 240, 150},
                             {"5 h, 3 h", 300, 180},
                             {"Hokkaido 2 h, 1.5 h", 120, 90},
                             {"Hokkaido 3 h, 2 h", 180, 120},
                             {"Hokkaido 4 h, 2.5 h", 240, 150}}) {
        const Rule rule = shippedRule("japan", {{"limits", zone.name}});
        const auto verdict = [&](LineBelt belt, int minutes) {
            return verdictOf(rule, times(2, lit(360)), {lit(360), shaded(minutes) + lit(360 - minutes)},
                             {.kind = PlaceKind::other, .belt = belt});
        };
        EXPECT_EQ(verdict(LineBelt::betweenLines, zone.inner - 2), pass) << zone.name;
        EXPECT_EQ(verdict(LineBelt::betweenLines, zone.inner), borderline) << zone.name;
        EXPECT_EQ(verdict(LineBelt::betweenLines, zone.inner + 2), fail) << zone.name;
        EXPECT_EQ(verdict(LineBelt::beyondLines, zone.outer - 2), pass) << zone.name;
        EXPECT_EQ(verdict(LineBelt::beyondLines, zone.outer), borderline) << zone.name;
        EXPECT_EQ(verdict(LineBelt::beyondLines, zone.outer + 2), fail) << zone.name;
    }
    for (const auto& [plane, metres] : {std::pair{"1.5 m", 1.5}, {"4 m", 4.0}, {"6.5 m", 6.5}})
        EXPECT_EQ(shippedRule("japan", {{"plane", plane}}).receivers.planeM, metres);
}

TEST(RussiaRule, CountsSpotsWithUnbrokenOrEnoughBrokenSun) {
    // 2 h unbroken, or 2.5 h in parts of which one has an hour.
    const Cells cells{lit(130) + shaded(170),                                 // 130 unbroken: yes
                      lit(100) + shaded(150) + lit(50),                       // 100 + 50 = 150: yes
                      lit(50) + shaded(60) + lit(50) + shaded(80) + lit(60),  // 160, longest 60: yes
                      lit(55) + shaded(60) + lit(55) + shaded(80) + lit(50),  // 160, longest 55: no
                      lit(100) + shaded(160) + lit(40)};                      // 140: no
    const PlaceReview review = reviewOf(shippedRule("russia-territory"), times(5, lit(300)), cells);
    EXPECT_DOUBLE_EQ(review.results.at(0).value->value, 0.6);
    EXPECT_EQ(review.verdict, notApplicable) << "no share is stated";
    EXPECT_DOUBLE_EQ(review.rows.at(0).minSunMin, 130);
    EXPECT_EQ(review.rows.at(0).minSunIntervals, 1);
    EXPECT_DOUBLE_EQ(review.rows.at(0).minSunRunMin, 130);     // of that spot
    EXPECT_DOUBLE_EQ(review.rows.at(0).minLongestSunMin, 55);  // of the fourth
}

TEST(OwnRule, AllowsAnHourAtASpot) {
    const Rule rule = shippedRule("own");
    const auto verdict = [&](int minutes) {
        return verdictOf(rule, times(2, lit(100)), {lit(100), shaded(minutes) + lit(100 - minutes)});
    };
    EXPECT_EQ(verdict(58), pass);
    EXPECT_EQ(verdict(60), borderline);
    EXPECT_EQ(verdict(62), fail);
}

}  // namespace

}  // namespace noonmark
