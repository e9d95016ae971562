#pragma once

#include "core/review/library/rule_fields.h"

namespace noonmark {

// The parts of a rule; each reads the field of its name (docs/rules.md).

RuleDays readDays(RuleFields& rule, const std::string& ruleSource);
CountedHours readRuleHours(RuleFields& rule, const std::string& ruleSource);
RuleClock readClock(RuleFields& rule, const std::string& ruleSource);
RuleSampling readSampling(RuleFields& rule, const std::string& ruleSource);
RuleReceivers readReceivers(RuleFields& rule, const std::string& ruleSource);
RuleOccluders readOccluders(RuleFields& rule, const std::string& ruleSource);
RuleBaseline readBaseline(RuleFields& rule, const std::string& ruleSource);
Deliverables readDeliverables(RuleFields& rule, const std::string& ruleSource);

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
