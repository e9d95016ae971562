#include <gtest/gtest.h>
#include <cmath>
#include <limits>

#include "core/describe/answer_page.h"

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

TEST(Sentence, IsFilledInWithNamesAndAmounts) {
    const Sentence sentence{
        "%1: %2 of sun a day, %3 in shade",
        {std::string("Bryant Park"), Amount{258, FigureUnit::hours}, Amount{0.652, FigureUnit::share, 0}}};
    EXPECT_EQ(formatText(sentence), "Bryant Park: 4.3 h of sun a day, 65 % in shade");
}

TEST(Sentence, ANameThatLooksLikeAnArgumentStaysAsItIs) {
    const Sentence sentence{"%2 against %1", {std::string("%2"), std::string("100 %1")}};
    EXPECT_EQ(formatText(sentence), "100 %1 against %2");
}

TEST(Sentence, BeginsWithACapital) {
    EXPECT_EQ(formatText(Sentence{"%1 changes nothing", {std::string("the tower")}}),
              "The tower changes nothing");
}

TEST(Sentence, PlacesInAnyOrderAndSignsOfPercentStay) {
    EXPECT_EQ(fillIn("50 % of %2, %1, %3 and %", std::vector<std::string>{"a", "b"}),
              "50 % of b, a, %3 and %");
    EXPECT_EQ(fillIn("%", std::vector<std::string>{"a"}), "%");
}

TEST(Sentence, AreasFollowTheUnitsInUseAndChangesHaveTheirSign) {
    EXPECT_EQ(valueOf(Amount{1204.4, FigureUnit::squareMetres, 0, true}), "+1,204 m²");
    EXPECT_EQ(valueOf(Amount{100, FigureUnit::squareMetres}, UnitSystem::imperial), "1,076 sq ft");
    EXPECT_EQ(valueOf(Amount{std::nan(""), FigureUnit::minutes}), "not counted");
}

}  // namespace

}  // namespace noonmark
