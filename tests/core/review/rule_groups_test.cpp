#include "core/review/library/rule_library.h"

#include <gmock/gmock.h>

#include "core/sun/zone_country.h"

namespace noonmark {
namespace {

using testing::ElementsAre;

Rule ruleOf(const std::string& key, const std::string& where, std::vector<std::string> countries) {
    Rule rule;
    rule.key = key;
    rule.where = where;
    rule.countries = std::move(countries);
    return rule;
}

std::vector<std::string> namesOf(const std::vector<RuleGroup>& groups) {
    std::vector<std::string> names;
    for (const RuleGroup& group : groups) names.push_back(group.name + (group.isAbroad ? " abroad" : ""));
    return names;
}

TEST(RuleGroups, PutTheRulesOfTheSitesCountryFirstAndMarkThoseOfOthers) {
    const std::vector<Rule> rules{ruleOf("a", "Anywhere", {}), ruleOf("b", "Boston", {"US"}),
                                  ruleOf("e", "Europe", {"FR", "CH"}), ruleOf("z", "Zurich", {"CH"})};
    EXPECT_THAT(namesOf(groupByCountry(rules, "CH")),
                ElementsAre("Europe", "Switzerland", "Any country", "United States abroad"));
    EXPECT_THAT(namesOf(groupByCountry(rules, "US")),
                ElementsAre("United States", "Any country", "Europe abroad", "Switzerland abroad"));
    EXPECT_THAT(namesOf(groupByCountry(rules, "")),
                ElementsAre("Any country", "Europe", "Switzerland", "United States"));
}

TEST(RuleGroups, HoldEveryShippedRuleOnce) {
    const RuleLibrary library = RuleLibrary::load({}).value();
    std::size_t count = 0;
    for (const RuleGroup& group : groupByCountry(library.rules(), "GB")) count += group.rules.size();
    EXPECT_EQ(count, library.rules().size());
}

TEST(SuggestRule, TakesTheRuleOfTheCityThenOfTheCountryThenOfSeveral) {
    const RuleLibrary library = RuleLibrary::load({}).value();
    const auto at = [&](std::string_view country, LonLat site) {
        return suggestRule(library.rules(), country, site);
    };
    EXPECT_EQ(at("US", {-73.98, 40.75}), "ceqr");
    EXPECT_EQ(at("US", {-122.4, 37.79}), "san-francisco-295");
    EXPECT_EQ(at("US", {-71.06, 42.355}), "boston-article-80");
    EXPECT_EQ(at("US", {-87.63, 41.88}), "four-days");  // Chicago: no rule of its own
    EXPECT_EQ(at("GB", {-0.1, 51.5}), "bre-209-amenity");
    EXPECT_EQ(at("NL", {4.48, 51.92}), "tno-light");  // Rotterdam
    EXPECT_EQ(at("NL", {4.3, 52.08}), "the-hague");
    EXPECT_EQ(at("CZ", {14.42, 50.09}), "en-17037");  // Prague
    EXPECT_EQ(at("EG", {29.9, 31.2}), "four-days");
    EXPECT_EQ(at("", {0, 0}), "four-days");
}

TEST(ZoneCountry, IsThatOfTheTzDatabase) {
    EXPECT_EQ(countryOfZone("America/Chicago"), "US");
    EXPECT_EQ(countryOfZone("Europe/Monaco"), "MC");
    EXPECT_EQ(countryOfZone("UTC"), "");
    EXPECT_EQ(countryName("CH"), "Switzerland");
    EXPECT_EQ(countryName("??"), "??");
}

}  // namespace
}  // namespace noonmark
