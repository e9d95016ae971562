#include "scenarios/weights/edit_weights.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "scenarios/weights/weights_text.h"

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

}  // namespace
}  // namespace noonmark::tests
