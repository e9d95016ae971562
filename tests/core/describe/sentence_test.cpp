#include "core/describe/sentence.h"

#include <gtest/gtest.h>

#include <cmath>

namespace noonmark {
namespace {

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
    EXPECT_EQ(formatText({"%1 changes nothing", {std::string("the tower")}}), "The tower changes nothing");
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
