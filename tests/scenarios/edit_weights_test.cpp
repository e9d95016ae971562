#include "scenarios/weights/edit_weights.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "scenarios/weights/time_weights.h"

namespace noonmark::tests {
namespace {

using namespace std::chrono;
using testing::HasSubstr;

TEST(EditedWeights, ANewIntervalTakesTheFreeDaysAfterTheOneBeforeIt) {
    TimeWeights table{"mine",
                      {{.name = "spring", .first = March / 1, .last = May / 31, .weight = 1},
                       {.name = "autumn", .first = September / 1, .last = November / 30, .weight = 1}}};
    const AddedInterval summer = addInterval(table, 0).value();
    EXPECT_EQ(summer.position, 1U);
    EXPECT_EQ(summer.table.intervals[1].first, June / 1);
    EXPECT_EQ(summer.table.intervals[1].last, August / 31);
    EXPECT_EQ(summer.table.intervals[1].name, "06-01 to 08-31");
    EXPECT_EQ(summer.table.intervals[1].weight, 0);
    const AddedInterval december = addInterval(summer.table, 2).value();
    EXPECT_EQ(december.table.intervals[3].first, December / 1);
    EXPECT_EQ(december.table.intervals[3].last, December / 31);
    const AddedInterval winter = addInterval(december.table, 3).value();
    EXPECT_EQ(winter.table.intervals[4].first, January / 1);
    EXPECT_EQ(winter.table.intervals[4].last, February / 29);
    EXPECT_TRUE(validate(winter.table));
}

TEST(EditedWeights, AFullTableGivesHalfOfTheIntervalBefore) {
    const AddedInterval added = addInterval(makeMonthlyWeights(), 5).value();
    EXPECT_EQ(added.table.intervals.size(), 13U);
    EXPECT_EQ(added.table.intervals[5].last, June / 15);
    EXPECT_EQ(added.table.intervals[6].first, June / 16);
    EXPECT_EQ(added.table.intervals[6].last, June / 30);
    EXPECT_EQ(added.table.intervals[6].weight, 1);
    EXPECT_TRUE(validate(added.table));
}

TEST(EditedWeights, IntervalsOverNewYearAreHalvedAround) {
    const TimeWeights table{"two",
                            {{.name = "winter", .first = October / 1, .last = March / 31, .weight = -1},
                             {.name = "summer", .first = April / 1, .last = September / 30}}};
    const AddedInterval added = addInterval(table, 0).value();
    EXPECT_EQ(added.table.intervals[0].first, October / 1);
    EXPECT_EQ(added.table.intervals[1].last, March / 31);
    EXPECT_TRUE(validate(added.table)) << validate(added.table).error().text();
}

TEST(EditedWeights, AddingGoesOnUntilADayIsLeft) {
    TimeWeights table{"mine", {{.name = "all", .weight = 0.5}}};
    for (int i = 0; i < 365; ++i) {
        std::size_t longest = 0;
        while (table.intervals[longest].first == table.intervals[longest].last) ++longest;
        table = addInterval(table, longest).value().table;
        ASSERT_TRUE(validate(table));
    }
    ASSERT_EQ(table.intervals.size(), 366U);
    EXPECT_THAT(addInterval(table, 7).error().text(), HasSubstr("a single day"));
}

TEST(EditedWeights, TheLastIntervalStays) {
    EXPECT_EQ(removeInterval(makeMonthlyWeights(), 0)->intervals.size(), 11U);
    EXPECT_THAT(removeInterval({"one", {{.name = "all"}}}, 0).error().text(), HasSubstr("no intervals"));
}

TEST(EditedWeights, AnIntervalIsReadFromItsTexts) {
    const WeightedInterval june = makeMonthlyWeights().intervals[5];
    EXPECT_EQ(intervalFrom(textsOf(june), "here").value(), june);
    auto texts = textsOf(june);
    texts["first"] = "Feb";
    texts["last"] = "february";
    EXPECT_EQ(intervalFrom(texts, "here")->first, February / 1);
    EXPECT_EQ(intervalFrom(texts, "here")->last, February / 29);
    texts["weight"] = "1.5";
    EXPECT_THAT(intervalFrom(texts, "row 6").error().text(), HasSubstr("row 6: '1.5' is not a weight"));
    texts["weight"] = "1";
    texts["last"] = "Fe";
    EXPECT_THAT(intervalFrom(texts, "row 6").error().text(), HasSubstr("row 6, last: 'Fe' is not a day"));
}

std::vector<std::string> linesOf(const TimeWeights& table) {
    std::vector<std::string> lines;
    for (const WeightedInterval& one : table.intervals) {
        const auto texts = textsOf(one);
        lines.push_back(texts.at("name") + "|" + texts.at("first") + " " + texts.at("last") + "|" +
                        texts.at("from") + " " + texts.at("to") + "|" + texts.at("weight"));
    }
    return lines;
}

TEST(PaintedWeights, KeepTheExactDatesAndHoursOfWhatIsNotPainted) {
    const TimeWeights table{
        "mine",
        {{.name = "term", .first = May / 10, .last = June / 20, .from = 7h + 30min, .to = 18h, .weight = 0.5},
         {.name = "night", .from = 22h, .to = 5h, .weight = -1}}};
    const auto painted = paintWeights(table, {June, July, 12, 16}, 1).value();
    EXPECT_THAT(linesOf(painted),
                testing::ElementsAre("term|05-10 05-31|07:30 18:00|0.5", "term|06-01 06-20|07:30 12:00|0.5",
                                     "term|06-01 06-20|16:00 18:00|0.5", "night|01-01 12-31|22:00 05:00|-1",
                                     "06-01 to 07-31, 12:00 to 16:00|06-01 07-31|12:00 16:00|1"));
}

TEST(PaintedWeights, JoinPaintedNeighboursOfTheSameWeight) {
    TimeWeights table{"mine", {{.name = "new year", .first = December / 31, .last = January / 1}}};
    table = paintWeights(table, {June, June, 12, 16}, 1).value();
    table = paintWeights(table, {August, August, 12, 16}, 1).value();
    EXPECT_EQ(table.intervals.size(), 3U);
    table = paintWeights(table, {July, July, 12, 16}, 1).value();
    EXPECT_THAT(linesOf(table),
                testing::ElementsAre("new year|12-31 01-01|00:00 24:00|0",
                                     "06-01 to 08-31, 12:00 to 16:00|06-01 08-31|12:00 16:00|1"));
    table = paintWeights(table, {June, August, 16, 18}, 0.5).value();
    EXPECT_EQ(table.intervals.size(), 3U) << "another weight";
    EXPECT_EQ(paintWeights(makeMonthlyWeights(), {July, July, 0, 24}, 1).value().intervals.size(), 12U)
        << "intervals with a name of their own stay apart";
}

// The score is by interval: a hole that is filled again must leave none behind.
TEST(PaintedWeights, AHoleThatIsFilledLeavesTheTableAsItWas) {
    const TimeWeights table{"mine",
                            {{.name = "winter",
                              .first = November / 1,
                              .last = February / 29,
                              .from = 9h,
                              .to = 16h,
                              .weight = -1}}};
    const auto holed = paintWeights(table, {February, February, 11, 12}, 1).value();
    EXPECT_THAT(linesOf(holed),
                testing::ElementsAre("winter|11-01 01-31|09:00 16:00|-1", "winter|02-01 02-29|09:00 11:00|-1",
                                     "winter|02-01 02-29|12:00 16:00|-1",
                                     "02-01 to 02-29, 11:00 to 12:00|02-01 02-29|11:00 12:00|1"));
    EXPECT_EQ(paintWeights(holed, {February, February, 11, 12}, -1).value(), table);
    const auto late = paintWeights(table, {December, December, 9, 16}, 1).value();
    EXPECT_EQ(late.intervals.size(), 3U);
    EXPECT_EQ(paintWeights(late, {December, December, 9, 16}, -1).value(), table);
}

TEST(PaintedWeights, AreErasedAndRefused) {
    const auto without = paintWeights(makeMonthlyWeights(), {January, November, 0, 24}, {}).value();
    EXPECT_THAT(linesOf(without), testing::ElementsAre("December|12-01 12-31|00:00 24:00|-1"));
    EXPECT_FALSE(paintWeights(without, {December, December, 0, 24}, {})) << "the table would be empty";
    EXPECT_FALSE(paintWeights(without, {June, June, 5, 5}, 1)) << "no hour";
    EXPECT_FALSE(paintWeights(without, {June, June, 5, 6}, 1.5)) << "no such weight";
}

TEST(PaintedWeights, TheGridStatesWhatEachHourOfAMonthHolds) {
    const auto grid = weightGrid(
        {"mine",
         {{.name = "half June", .first = June / 1, .last = June / 15, .weight = 1},
          {.name = "July", .first = July / 1, .last = July / 31, .from = 22h, .to = 5h, .weight = -0.5}}});
    EXPECT_TRUE(grid[5][0].isHeld);
    EXPECT_TRUE(grid[5][0].isMixed) << "the second half of June has no weight";
    EXPECT_EQ(grid[5][0].weight, 1);
    EXPECT_TRUE(grid[6][4].isHeld);
    EXPECT_FALSE(grid[6][4].isMixed);
    EXPECT_EQ(grid[6][23].weight, -0.5);
    EXPECT_FALSE(grid[6][5].isHeld);
}

TEST(WeightTemplates, WantShadeInSummerAfternoonsAndSunInWinter) {
    const TimeWeights chicago = makeComfortWeights(41.9);
    const auto grid = weightGrid(chicago);
    EXPECT_EQ(grid[6][14].weight, 1) << "a July afternoon";
    EXPECT_FALSE(grid[6][8].isHeld) << "a July morning";
    EXPECT_EQ(grid[0][12].weight, -1) << "noon in January";
    EXPECT_FALSE(findSeasonMismatch(chicago, 41.9));
    EXPECT_TRUE(findSeasonMismatch(chicago, -37.8));
}

TEST(WeightTemplates, AreHalfAYearLaterInTheSouth) {
    for (const double latitude : {10.0, 30.0, 45.0, 65.0})
        for (const auto& make : {makeComfortWeights, makePlantWeights}) {
            const auto north = weightGrid(make(latitude)), south = weightGrid(make(-latitude));
            for (std::size_t at = 0; at < 12; ++at)
                for (std::size_t hour = 0; hour < 24; ++hour) {
                    const WeightCell &here = north[at][hour], &there = south[(at + 6) % 12][hour];
                    EXPECT_EQ(here.isHeld, there.isHeld) << latitude << " " << at << " " << hour;
                    EXPECT_EQ(here.weight, there.weight);
                    EXPECT_FALSE(here.isMixed);
                }
        }
    EXPECT_FALSE(findSeasonMismatch(makeComfortWeights(-37.8), -37.8));
}

TEST(WeightTemplates, GivePlantsSunInTheirGrowingSeason) {
    const TimeWeights monaco = makePlantWeights(43.7);
    EXPECT_THAT(linesOf(monaco), testing::ElementsAre("growing season|04-01 09-30|06:00 20:00|-1"));
    EXPECT_THAT(linesOf(makePlantWeights(-60)),
                testing::ElementsAre("growing season|11-01 02-29|06:00 20:00|-1"));
    EXPECT_FALSE(findSeasonMismatch(monaco, 43.7)) << "it wants no shade, so it cannot want it in winter";
    EXPECT_TRUE(validate(makePlantWeights(-5))) << "all year";
}

}  // namespace
}  // namespace noonmark::tests
