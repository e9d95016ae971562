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

TEST(ZoneCountry, IsThatOfTheTzDatabase) {
    EXPECT_EQ(countryOfZone("America/Chicago"), "US");
    EXPECT_EQ(countryOfZone("Europe/Monaco"), "MC");
    EXPECT_EQ(countryOfZone("UTC"), "");
    EXPECT_EQ(countryName("CH"), "Switzerland");
    EXPECT_EQ(countryName("??"), "??");
}

}  // namespace
}  // namespace noonmark
