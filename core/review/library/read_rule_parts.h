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

}  // namespace noonmark
