#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/base/warnings.h"
#include "core/describe/text.h"
#include "core/geo/frame.h"
#include "core/review/library/read_rule.h"
#include "core/review/rule/rule.h"

namespace noonmark {

/// The name of the group of rules that name no country.
inline constexpr const char* anyCountry = NM_TEXT("Any country");

/// Rules of one country, or of several that share a rule.
struct RuleGroup {
    std::string name;       ///< "United States", "Europe"; anyCountry of rules that name none
    bool isAbroad = false;  ///< the site lies in another country
    std::vector<const Rule*> rules;
};

/// Groups rules by country: those of the site's first, then those of any country, then the others by name.
/// `site`: its ISO 3166-1 code (zone_country.h); empty: not known, and nothing is abroad. The rules must
/// outlive the groups.
std::vector<RuleGroup> groupByCountry(const std::vector<Rule>& rules, std::string_view site);

/// The key of the rule that a review at `site` begins with: that of its city, else of its country, else one
/// that several countries share, else the diagrams of four days. `country`: as above. Of several, those about
/// ground come first.
std::string suggestRule(const std::vector<Rule>& rules, std::string_view country, LonLat site);

/// The rules that ship with Noonmark (resources/rules) and those of the user's folders.
class RuleLibrary {
public:
    /// Reads `*.json` in each folder, not in folders below; at most 1,000 files each. A file that is no rule,
    /// or whose key is already taken, is left out with a warning. Error: a folder that cannot be read.
    static Result<RuleLibrary> load(const std::vector<std::filesystem::path>& folders = {});

    /// Sorted by key, each with the first option of its choices.
    [[nodiscard]] const std::vector<Rule>& rules() const { return rules_; }
    [[nodiscard]] const Warnings& warnings() const { return warnings_; }

    /// The rule of that key with the chosen options. Error: no such rule, with similar keys; or parseRule().
    [[nodiscard]] Result<Rule> find(std::string_view key, const RuleChoices& choices = {}) const;

    /// The file's text of that rule: a start for one's own. Error: no such rule.
    [[nodiscard]] Result<std::string> textOf(std::string_view key) const;

private:
    void take(std::string text, const std::string& file);

    std::vector<Rule> rules_;
    std::vector<std::string> texts_;  // by rule
    Warnings warnings_;
};

}  // namespace noonmark
