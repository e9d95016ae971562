#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "scenarios/scenario.h"
#include "tests/scenarios/small_town.h"

namespace noonmark::tests {

namespace {

using testing::HasSubstr;

std::vector<Scenario> chain() { return {{"A", "", {Demolish{"x"}}}, {"B", "A", {}}, {"C", "B", {}}}; }

TEST(ScenarioList, ANewNameGoesAlongToThoseThatStartFromIt) {
    auto scenarios = chain();
    ASSERT_TRUE(renameScenario(scenarios, "A", "First"));
    EXPECT_EQ(scenarios[0].name, "First");
    EXPECT_EQ(scenarios[1].base, "First");
    EXPECT_EQ(collectEdits(scenarios, "C").value().size(), 1U);
}

TEST(ScenarioList, ACopyHasTheSameEditsAndNobodyStartsFromIt) {
    auto scenarios = chain();
    ASSERT_TRUE(duplicateScenario(scenarios, "B", "B2"));
    EXPECT_EQ(scenarios[2].name, "B2");
    EXPECT_EQ(scenarios[2].base, "A");
    EXPECT_EQ(scenarios[3].base, "B");
}

TEST(ScenarioList, OnlyWhatNobodyStartsFromIsRemoved) {
    auto scenarios = chain();
    EXPECT_THAT(removeScenario(scenarios, "A").error().text(), HasSubstr("Remove them first: B"));
    for (const char* name : {"C", "B", "A"}) EXPECT_TRUE(removeScenario(scenarios, name));
    EXPECT_TRUE(scenarios.empty());
}

TEST(ScenarioList, WhatCannotBeLeavesTheListAsItWas) {
    auto scenarios = chain();
    EXPECT_FALSE(renameScenario(scenarios, "D", "E"));
    EXPECT_FALSE(renameScenario(scenarios, "A", "B"));
    EXPECT_FALSE(renameScenario(scenarios, "A", ""));
    EXPECT_FALSE(renameScenario(scenarios, "A", existingCity));
    EXPECT_FALSE(renameScenario(scenarios, existingCity, "E"));
    EXPECT_FALSE(duplicateScenario(scenarios, "A", "B"));
    EXPECT_FALSE(duplicateScenario(scenarios, "", "D"));
    EXPECT_FALSE(removeScenario(scenarios, existingCity));
    EXPECT_FALSE(removeScenario(scenarios, "D"));
    EXPECT_EQ(scenarios, chain());
}

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
    EXPECT_THAT(validate(std::vector<Scenario>{{"A", "B", {}}, {"B", "A", {}}}).error().text(),
                HasSubstr("starts from itself"));
    EXPECT_THAT(validate(std::vector<Scenario>{{"A", "", {}}, {"A", "", {}}}).error().text(),
                HasSubstr("Two scenarios"));
    EXPECT_FALSE(validate(std::vector<Scenario>{{existingCity, "", {}}}));
    EXPECT_FALSE(validate(std::vector<Scenario>{{"A", "gone", {}}}));
    EXPECT_TRUE(validate(twoProposals()));
}

}  // namespace

}  // namespace noonmark::tests
