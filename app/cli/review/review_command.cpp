#include "app/cli/review/review_command.h"

#include <fmt/format.h>
#include <algorithm>
#include <memory>
#include <ostream>

#include "core/describe/command_options.h"
#include "core/review/library/rule_text.h"
#include "core/review/rule/rule_names.h"
#include "core/study/text/error_text.h"
#include "core/sun/zone_country.h"

namespace noonmark::cli {

void addReviewCommand(CLI::App& app, Run& run) {
    CLI::App* review =
        app.add_subcommand("review", "Evaluate the rule of a review board on the places of a project");
    review->require_subcommand(1);
    addReviewList(*review, run);
    addReviewShow(*review, run);
    addReviewRun(*review, run);
}

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

namespace {

using Json = nlohmann::ordered_json;

struct RuleListOptions {
    RuleOptions rules;
    std::string zone;  ///< of the site; empty: not known
    bool json = false;
};

struct RuleShowOptions {
    RuleOptions rules;
    std::string key;
    bool json = false;
};

Json listJson(const RuleLibrary& library) {
    Json rules = Json::array();
    for (const Rule& rule : library.rules()) {
        Json choices = Json::object();
        for (const auto& [choice, options] : rule.choices) choices[choice] = options;
        rules.push_back({{"rule", rule.key},
                         {"name", rule.name},
                         {"where", rule.where},
                         {"countries", rule.countries},
                         {"summary", rule.summary},
                         {"status", ruleNameOf(figureStatusNames(), findLeastCertain(rule))},
                         {"choices", choices},
                         {"file", rule.file.empty() ? Json() : Json(rule.file)}});
    }
    return {{"rules", rules}, {"warnings", warningsJson(library.warnings())}};
}

void printRules(const RuleLibrary& library, const std::string& site, std::ostream& out) {
    std::size_t width = 0;
    for (const Rule& rule : library.rules()) width = std::max(width, rule.key.size());
    for (const RuleGroup& group : groupByCountry(library.rules(), site)) {
        out << fmt::format("{}{}\n", group.name, group.isAbroad ? " (not where the site is)" : "");
        for (const Rule* rule : group.rules)
            out << fmt::format("  {:<{}}  {}  {}\n", rule->key, width,
                               ruleNameOf(figureStatusNames(), findLeastCertain(*rule)), rule->name);
    }
    out << "\nThe letter is that of the least certain figure that a verdict rests on. V: read in the rule's "
           "text or on an official page; R: reported by practice; U: not checked against the rule's text.\n";
    for (const WarningGroup& group : groupWarnings(library.warnings())) out << lineOf(group) << '\n';
}

int runReviewList(const RuleListOptions& options, const Console& console) {
    const auto library = loadRules(options.rules);
    if (!library) return fail(console, library.error(), exitUsage);
    if (!options.zone.empty())
        if (const auto zone = Zone::named(options.zone); !zone) return fail(console, zone.error(), exitUsage);
    if (options.json)
        console.out << toJsonText(listJson(*library)) << '\n';
    else
        printRules(*library, countryOfZone(options.zone), console.out);
    return exitOk;
}

int runReviewShow(const RuleShowOptions& options, const Console& console) {
    const auto library = loadRules(options.rules);
    if (!library) return fail(console, library.error(), exitUsage);
    const auto rule = findRule(*library, options.key, options.rules);
    if (!rule) return fail(console, rule.error(), exitUsage);
    if (options.json)
        console.out << library->textOf(options.key).value();
    else
        console.out << describeRule(*rule);
    return exitOk;
}

}  // namespace

void addReviewList(CLI::App& review, Run& run) {
    const auto options = std::make_shared<RuleListOptions>();
    CLI::App* command = review.add_subcommand("list", "List the rules by country");
    command
        ->add_option("--zone", options->zone,
                     "Time zone of the site: the rules of its country come first, and those of others are "
                     "marked")
        ->type_name("ZONE");
    addRuleFolders(*command, options->rules);
    addJsonFlag(*command, options->json);
    command->callback([options, &run] {
        run = [options](const Console& console) { return runReviewList(*options, console); };
    });
}

void addReviewShow(CLI::App& review, Run& run) {
    const auto options = std::make_shared<RuleShowOptions>();
    CLI::App* command = review.add_subcommand("show", "Show a rule: each figure with its status and source");
    command->add_option("rule", options->key, "Key of the rule")->required()->type_name("RULE");
    addRuleFolders(*command, options->rules);
    addRuleChoices(*command, options->rules);
    addJsonFlag(*command, options->json, "Print the rule's file, a start for a rule of your own");
    command->footer("noonmark-cli review show japan --choose \"plane=1.5 m\"");
    command->callback([options, &run] {
        run = [options](const Console& console) { return runReviewShow(*options, console); };
    });
}

}  // namespace noonmark::cli
