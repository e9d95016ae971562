#include <fmt/format.h>

#include <memory>

#include "app/cli/project/edit_scenario.h"
#include "app/cli/project/project_commands.h"
#include "scenarios/scenario.h"

namespace noonmark::cli {

namespace {

struct NameOptions {
    ChangeOptions change;
    std::string name;
};

struct AddScenarioOptions : NameOptions {
    std::string base;
};

struct RenameOptions : NameOptions {
    std::string newName;
};

struct RemoveEditOptions : EditOptions {
    std::vector<std::size_t> numbers;  // from 1, as listed by `info`
};

Result<std::string> addScenario(const AddScenarioOptions& options, Project& project) {
    const std::string base = options.base == existingCity ? "" : options.base;
    project.scenarios.push_back({options.name, base, {}});
    return validate(project.scenarios).map([&] {
        return fmt::format("{}: starts from {}\n", options.name, options.base);
    });
}

Result<std::string> duplicate(const RenameOptions& options, Project& project) {
    return duplicateScenario(project.scenarios, options.name, options.newName).map([&] {
        return fmt::format("{}: a copy of {}\n", options.newName, options.name);
    });
}

Result<std::string> rename(const RenameOptions& options, Project& project) {
    return renameScenario(project.scenarios, options.name, options.newName).map([&] {
        return fmt::format("{}: was {}\n", options.newName, options.name);
    });
}

Result<std::string> removeScenarios(const NameOptions& options, Project& project) {
    return removeScenario(project.scenarios, options.name).map([&] {
        return fmt::format("{}: removed\n", options.name);
    });
}

Result<std::string> removeEdits(const RemoveEditOptions& options, Project& project) {
    const auto scenario = scenarioToChange(project, options.scenario);
    if (!scenario) return tl::make_unexpected(scenario.error());
    std::vector<Edit>& edits = (*scenario)->edits;
    std::string words;
    std::vector<bool> goes(edits.size(), false);
    for (const std::size_t number : options.numbers) {
        if (number < 1 || number > edits.size())
            return failure(fmt::format("There is no edit {}", number),
                           fmt::format("scenario '{}'", options.scenario),
                           edits.empty() ? "It has none" : fmt::format("Give 1 to {}", edits.size()));
        goes[number - 1] = true;
        words += fmt::format("{}: no longer {}\n", options.scenario, formatText(edits[number - 1]));
    }
    std::size_t at = 0;
    std::erase_if(edits, [&](const Edit&) { return goes[at++]; });
    return checkApplies(project, options.scenario).map([&] { return words; });
}

void addNames(CLI::App& command, RenameOptions& options) {
    command.add_option("name", options.name, "The scenario")->required()->type_name("NAME");
    command.add_option("new-name", options.newName, "The new name, not yet in use")
        ->required()
        ->type_name("NEW");
}

}  // namespace

void addProjectScenarios(CLI::App& project, Run& run) {
    const auto adding = std::make_shared<AddScenarioOptions>();
    CLI::App* command =
        addChangeCommand(project, "add-scenario", "Add a scenario without edits", adding, addScenario, run);
    command->add_option("name", adding->name, "Name of the scenario")->required()->type_name("NAME");
    command->add_option("--base", adding->base, "The scenario that it starts from")
        ->default_val(existingCity)
        ->type_name("NAME");
    const auto copying = std::make_shared<RenameOptions>();
    addNames(*addChangeCommand(project, "duplicate-scenario", "Add a scenario with another's base and edits",
                               copying, duplicate, run),
             *copying);
    const auto renaming = std::make_shared<RenameOptions>();
    addNames(*addChangeCommand(project, "rename-scenario",
                               "Rename a scenario, and the base of the scenarios that start from it",
                               renaming, rename, run),
             *renaming);
    const auto removing = std::make_shared<NameOptions>();
    addChangeCommand(project, "remove-scenario", "Remove a scenario and its edits", removing, removeScenarios,
                     run)
        ->add_option("name", removing->name, "The scenario")
        ->required()
        ->type_name("NAME");
    const auto taking = std::make_shared<RemoveEditOptions>();
    addEditCommand(project, "remove-edit", "Remove edits of a scenario", taking, removeEdits, run)
        ->add_option("numbers", taking->numbers, "Numbers of the edits as `project info` lists them, from 1")
        ->required()
        ->type_name("NUMBER");
}

}  // namespace noonmark::cli
