#include "scenarios/scenario.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

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

}  // namespace
}  // namespace noonmark::tests
