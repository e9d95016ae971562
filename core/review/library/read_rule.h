#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>

#include "core/base/result.h"
#include "core/review/rule/rule.h"

namespace noonmark {

/// Option by choice: {"plane": "4 m"}.
using RuleChoices = std::map<std::string, std::string>;

/// Reads a rule (docs/rules.md). `file` names it in errors. A rule with choices is read with the option that
/// `choices` names, or else with the first option of each choice. Error, with the file and the field: text
/// that is not JSON, larger than 256 kB, nested more than 12 deep or with a field twice; a field that is
/// missing, unknown, of the wrong type or out of range; fields that contradict each other; a choice or option
/// that the rule does not have. Milliseconds.
Result<Rule> parseRule(std::string_view text, const std::string& file, const RuleChoices& choices = {});

/// The text of a rule file, for parseRule(). Error: it is not a regular file, cannot be read, or is too
/// large.
Result<std::string> readRuleText(const std::filesystem::path& file);

}  // namespace noonmark
