#pragma once

#include "core/review/library/rule_fields.h"

namespace noonmark {

/// Status and source of a part of a rule; the source of the rule where the part states none.
Evidence readEvidence(RuleFields& fields, const std::string& ruleSource);

/// The field `criteria` of a rule.
std::vector<Criterion> readCriteria(RuleFields& rule, const std::string& ruleSource);

/// The fields of `receivers` that are about windows: point, opening, sweep and unit.
RuleGlazing readRuleGlazing(RuleFields& receivers, const std::string& ruleSource);

/// The fields `holds_if`, `shares` and `sunshine` of a rule whose criteria have been read; trouble where
/// they, or criteria about windows, are in a rule about places.
void readGlazingVerdicts(RuleFields& fields, Rule& rule);

}  // namespace noonmark
