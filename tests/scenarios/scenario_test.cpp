#include "scenarios/scenario.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "scenarios/history.h"
#include "tests/scenarios/small_town.h"

namespace noonmark::tests {
namespace {

using testing::HasSubstr;

std::vector<Scenario> twoProposals() {
    return {{"A", "", {Demolish{"a"}}}, {"B", "A", {ChangeHeight{"b", 44}}}};
}

TEST(Scenario, StartsFromItsBase) {
    const City city = threeHouses();
    const EditedCity b = cityOf(city, twoProposals(), "B").value();
    ASSERT_EQ(b.city.buildings.size(), 2U);
    EXPECT_EQ(topM(*b.city.buildings[0]), 44);
    EXPECT_EQ(b.changes.removed.size(), 2U);
}

TEST(Scenario, ExistingIsTheCityItself) {
    const City city = threeHouses();
    EXPECT_EQ(cityOf(city, twoProposals(), existingCity).value().city.buildings, city.buildings);
}

TEST(Scenario, ErrorsSayWhichScenario) {
    const City city = threeHouses();
    EXPECT_THAT(cityOf(city, twoProposals(), "C").error().text(), HasSubstr("Existing, A, B"));
    EXPECT_THAT(cityOf(city, {{"A", "", {Demolish{"x"}}}}, "A").error().text(),
                testing::AllOf(HasSubstr("scenario 'A'"), HasSubstr("edit 1")));
}

TEST(Scenario, CirclesAndDoubleNamesAreRefused) {
    EXPECT_THAT(checked({{"A", "B", {}}, {"B", "A", {}}}).error().text(), HasSubstr("starts from itself"));
    EXPECT_THAT(checked({{"A", "", {}}, {"A", "", {}}}).error().text(), HasSubstr("Two scenarios"));
    EXPECT_FALSE(checked({{existingCity, "", {}}}));
    EXPECT_FALSE(checked({{"A", "gone", {}}}));
    EXPECT_TRUE(checked(twoProposals()));
}

TEST(History, UndoesAndRedoesWithoutLimit) {
    History<int> history(0);
    for (int i = 1; i <= 10000; ++i) history.change(i, "to " + std::to_string(i));
    for (int i = 10000; i > 0; --i) {
        EXPECT_EQ(history.undoText(), "to " + std::to_string(i));
        EXPECT_EQ(history.undo(), i - 1);
    }
    EXPECT_FALSE(history.canUndo());
    EXPECT_EQ(history.undo(), 0);
    while (history.canRedo()) history.redo();
    EXPECT_EQ(history.now(), 10000);
}

TEST(History, KnowsTheSavedState) {
    History<int> history(0);
    EXPECT_TRUE(history.isClean());
    history.change(1, "one");
    EXPECT_FALSE(history.isClean());
    history.markClean();
    history.change(2, "two");
    history.undo();
    EXPECT_TRUE(history.isClean());
    history.undo();
    EXPECT_FALSE(history.isClean());
    history.change(3, "three");  // the saved state can't be come back to
    history.undo();
    history.redo();
    EXPECT_FALSE(history.isClean());
}

}  // namespace
}  // namespace noonmark::tests
