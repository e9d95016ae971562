#include "core/describe/answer_page.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace noonmark {
namespace {

using namespace std::chrono;

Bars twoMonths() {
    return {.title = "Sun",
            .series = {"Existing", "Low", "Tall, with \"crown\""},
            .groups = {{2026y / January, {4, 3.5, 2}}, {2026y / February, {5, 5, 4.25}}}};
}

TEST(Bars, ChangesAreWhatEachSeriesHasMoreThanTheFirst) {
    const Bars changes = changesOf(twoMonths(), "Change");
    EXPECT_TRUE(changes.isChange);
    EXPECT_EQ(changes.series, (std::vector<std::string>{"Low", "Tall, with \"crown\""}));
    ASSERT_EQ(changes.groups.size(), 2U);
    EXPECT_EQ(changes.groups[0].values, (std::vector<double>{-0.5, -2}));
    EXPECT_EQ(changes.groups[1].values, (std::vector<double>{0, -0.75}));
    EXPECT_TRUE(changesOf(firstSeries(twoMonths(), 1), "Change").groups.empty()) << "there is no other";
}

TEST(Bars, AChangeAgainstNothingIsNone) {
    Bars bars = twoMonths();
    bars.groups[0].values[0] = std::numeric_limits<double>::quiet_NaN();
    EXPECT_TRUE(std::isnan(changesOf(bars, "Change").groups[0].values[1]));
}

TEST(Bars, AMonthIsCalledByItsYearToo) {
    EXPECT_EQ(groupKey(twoMonths().groups[1]), "2026-02");
    EXPECT_EQ(groupKey({std::string("0 to 1")}), "0 to 1");
    EXPECT_EQ(groupKey({Bars::Class{-5, 2.5}}), "-5 to 2.5");
}

}  // namespace
}  // namespace noonmark
