#pragma once

#include "core/review/library/rule_fields.h"

namespace noonmark {

/// Status and source of a part of a rule; the source of the rule where the part states none.
Evidence readEvidence(RuleFields& fields, const std::string& ruleSource);

/// The field `criteria` of a rule.
std::vector<Criterion> readCriteria(RuleFields& rule, const std::string& ruleSource);

}  // namespace noonmark
