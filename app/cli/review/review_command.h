#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "app/cli/base/command.h"
#include "core/review/library/rule_library.h"

namespace noonmark::cli {

// The commands of `review`.
void addReviewList(CLI::App& review, Run& run);
void addReviewShow(CLI::App& review, Run& run);
void addReviewRun(CLI::App& review, Run& run);

/// Where rules are found, and how they are read.
struct RuleOptions {
    std::vector<std::string> folders;
    std::vector<std::string> choices;  ///< "plane=4 m"
};

/// Adds --rules DIR (repeatable). `options` must outlive the command.
void addRuleFolders(CLI::App& command, RuleOptions& options);
/// Adds --choose CHOICE=OPTION (repeatable).
void addRuleChoices(CLI::App& command, RuleOptions& options);

Result<RuleLibrary> loadRules(const RuleOptions& options);

/// The rule of that key with the chosen options. Error: no such rule, or a choice it does not have.
Result<Rule> findRule(const RuleLibrary& library, const std::string& key, const RuleOptions& options);

}  // namespace noonmark::cli
