#include "core/review/library/rule_library.h"

#include <fmt/format.h>
#include <algorithm>
#include <map>
#include <tuple>

#include "core/geo/lon_lat.h"
#include "core/sun/zone_country.h"
#include "generated/shipped_rules.h"

namespace noonmark {

namespace {

std::string groupName(const Rule& rule) {
    if (rule.countries.empty()) return anyCountry;
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

std::string suggestRule(const std::vector<Rule>& rules, std::string_view country, LonLat site) {
    const auto reaches = [site](const Rule& rule) {
        return !rule.area || computeGreatCircleM(rule.area->centre, site) <= rule.area->radiusM;
    };
    const auto rank = [](const Rule* rule) {
        return std::tuple(!rule->area, rule->countries.size() > 1,
                          rule->receivers.surface != RuleSurface::ground);
    };
    std::vector<const Rule*> ofSite;
    for (const Rule& rule : rules)
        if (isOf(rule, country) && reaches(rule)) ofSite.push_back(&rule);
    const auto first = std::ranges::min_element(ofSite, {}, rank);
    return first == ofSite.end() ? "four-days" : (*first)->key;
}

namespace {

namespace fs = std::filesystem;

constexpr std::size_t maxRuleFiles = 1000;

Result<std::vector<fs::path>> ruleFilesIn(const fs::path& folder) {
    std::error_code error;
    std::vector<fs::path> files;
    for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error))
        if (entry->path().extension() == ".json") files.push_back(entry->path());
    if (error)
        return failure("The folder of rules cannot be read", folder.string(),
                       "Check its name and permissions");
    if (files.size() > maxRuleFiles)
        return limitReached(fmt::format("The folder holds more than {} rules", maxRuleFiles), folder.string(),
                            "Use a folder for rules only");
    std::ranges::sort(files);
    return files;
}

Warning leftOut(const Error& error) { return {WarningKind::dropped, error.what, error.where}; }

}  // namespace

void RuleLibrary::take(std::string text, const std::string& file) {
    const bool shipped = file.starts_with("shipped rule");
    auto rule = parseRule(text, file);
    if (!rule) return warnings_.push_back(leftOut(rule.error()));
    if (std::ranges::find(rules_, rule->key, &Rule::key) != rules_.end())
        return warnings_.push_back(
            {WarningKind::dropped, fmt::format("a rule '{}' is there already", rule->key), file});
    rule->file = shipped ? std::string() : file;
    const auto at = std::ranges::lower_bound(rules_, rule->key, {}, &Rule::key) - rules_.begin();
    texts_.insert(texts_.begin() + at, std::move(text));
    rules_.insert(rules_.begin() + at, *std::move(rule));
}

Result<RuleLibrary> RuleLibrary::load(const std::vector<fs::path>& folders) {
    RuleLibrary library;
    for (std::size_t i = 0; i < shippedRules.size(); ++i)
        library.take(std::string(shippedRules[i]), fmt::format("shipped rule {}", shippedRuleFiles[i]));
    for (const fs::path& folder : folders) {
        const auto files = ruleFilesIn(folder);
        if (!files) return tl::make_unexpected(files.error());
        for (const fs::path& file : *files) {
            auto text = readRuleText(file);
            if (text)
                library.take(*std::move(text), file.string());
            else
                library.warnings_.push_back(leftOut(text.error()));
        }
    }
    return library;
}

Result<std::string> RuleLibrary::textOf(std::string_view key) const {
    const auto found = std::ranges::find(rules_, key, &Rule::key);
    if (found != rules_.end()) return texts_[std::size_t(found - rules_.begin())];
    std::vector<std::string> keys;
    for (const Rule& rule : rules_) keys.push_back(rule.key);
    const auto close = findCloseNames(key, keys);
    return failure(fmt::format("There is no rule '{}'", key), {},
                   close.empty()
                       ? "`review list` shows all rules"
                       : fmt::format("Did you mean '{}'? `review list` shows all rules", close.front()));
}

Result<Rule> RuleLibrary::find(std::string_view key, const RuleChoices& choices) const {
    const auto text = textOf(key);
    if (!text) return tl::make_unexpected(text.error());
    const std::string& file = std::ranges::find(rules_, key, &Rule::key)->file;
    auto rule = parseRule(*text, file.empty() ? fmt::format("shipped rule {}", key) : file, choices);
    if (rule) rule->file = file;
    return rule;
}

}  // namespace noonmark
