#include "scenarios/scenario.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

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
    EXPECT_THAT(validate({{"A", "B", {}}, {"B", "A", {}}}).error().text(), HasSubstr("starts from itself"));
    EXPECT_THAT(validate({{"A", "", {}}, {"A", "", {}}}).error().text(), HasSubstr("Two scenarios"));
    EXPECT_FALSE(validate({{existingCity, "", {}}}));
    EXPECT_FALSE(validate({{"A", "gone", {}}}));
    EXPECT_TRUE(validate(twoProposals()));
}

}  // namespace
}  // namespace noonmark::tests
