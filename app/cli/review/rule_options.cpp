#include "app/cli/review/rule_options.h"
#include "core/describe/command_flags.h"

#include <fmt/format.h>

namespace noonmark::cli {

void addRuleFolders(CLI::App& command, RuleOptions& options) {
    command
        .add_option(flags::rules, options.folders,
                    "A folder with rules of your own (*.json), beside those that ship; may be repeated")
        ->type_name("DIR");
}

void addRuleChoices(CLI::App& command, RuleOptions& options) {
    command
        .add_option(flags::choose, options.choices,
                    "An option of a rule that has choices (`review show` lists them); may be repeated")
        ->type_name("CHOICE=OPTION");
}

Result<RuleLibrary> loadRules(const RuleOptions& options) {
    return RuleLibrary::load({options.folders.begin(), options.folders.end()});
}

Result<Rule> findRule(const RuleLibrary& library, const std::string& key, const RuleOptions& options) {
    RuleChoices choices;
    for (const std::string& choice : options.choices) {
        const auto sign = choice.find('=');
        if (sign == std::string::npos)
            return failure(fmt::format("'{}' is not CHOICE=OPTION", choice), flags::choose,
                           "Write \"plane=4 m\"");
        if (!choices.emplace(choice.substr(0, sign), choice.substr(sign + 1)).second)
            return failure(fmt::format("'{}' is chosen twice", choice.substr(0, sign)), flags::choose);
    }
    return library.find(key, choices);
}

}  // namespace noonmark::cli
