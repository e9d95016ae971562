#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/review/rule/rule.h"

namespace noonmark {

/// Rules of one country, or of several that share a rule.
struct RuleGroup {
    std::string name;       ///< "United States", "Europe"; "Any country" of rules that name none
    bool isAbroad = false;  ///< the site lies in another country
    std::vector<const Rule*> rules;
};

/// Groups rules by country: those of the site's first, then those of any country, then the others by name.
/// `site`: its ISO 3166-1 code (zone_country.h); empty: not known, and nothing is abroad. The rules must
/// outlive the groups.
std::vector<RuleGroup> groupByCountry(const std::vector<Rule>& rules, std::string_view site);

}  // namespace noonmark
