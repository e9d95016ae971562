#include "core/review/library/rule_groups.h"

#include <algorithm>
#include <map>

#include "core/sun/zone_country.h"

namespace noonmark {

namespace {

std::string groupName(const Rule& rule) {
    if (rule.countries.empty()) return "Any country";
    return rule.countries.size() == 1 ? countryName(rule.countries.front()) : rule.where;
}

bool isOf(const Rule& rule, std::string_view site) {
    return std::ranges::find(rule.countries, site) != rule.countries.end();
}

int rankOf(const RuleGroup& group, std::string_view site) {
    const Rule& rule = *group.rules.front();
    if (!site.empty() && isOf(rule, site)) return 0;
    return rule.countries.empty() ? 1 : 2;
}

}  // namespace

std::vector<RuleGroup> groupByCountry(const std::vector<Rule>& rules, std::string_view site) {
    std::map<std::string, RuleGroup> byName;
    for (const Rule& rule : rules) byName[groupName(rule)].rules.push_back(&rule);
    std::vector<RuleGroup> groups;
    for (auto& [name, group] : byName) {
        group.name = name;
        group.isAbroad = !site.empty() && rankOf(group, site) == 2;
        groups.push_back(std::move(group));
    }
    std::ranges::stable_sort(groups, {}, [&](const RuleGroup& group) { return rankOf(group, site); });
    return groups;
}

}  // namespace noonmark
