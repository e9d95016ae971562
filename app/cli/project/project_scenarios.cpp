#include <fmt/format.h>

#include <memory>

#include "app/cli/project/change_project.h"
#include "app/cli/project/project_commands.h"
#include "scenarios/edits/building_ids.h"

namespace noonmark::cli {

namespace {

struct AddOptions {
    std::string file;
    std::string name;
    std::string base;
};

Result<std::string> addScenario(const AddOptions& options, Project& project) {
    const std::string base = options.base == existingCity ? "" : options.base;
    project.scenarios.push_back({options.name, base, {}});
    if (const auto sound = checked(project); !sound) return tl::make_unexpected(sound.error());
    return fmt::format("{}: starts from {}\n", options.name, options.base);
}

struct DemolishOptions {
    std::string file;
    std::string scenario;
    std::vector<std::string> buildings;
};

Result<std::string> demolish(const DemolishOptions& options, Project& project) {
    const auto scenario = scenarioToChange(project, options.scenario);
    if (!scenario) return tl::make_unexpected(scenario.error());
    std::string words;
    for (const std::string& building : options.buildings) {
        const auto city = cityOf(project, options.scenario);
        if (!city) return tl::make_unexpected(city.error());
        const auto found = findBuilding(city->city, building);
        if (!found) return tl::make_unexpected(found.error());
        (*scenario)->edits.emplace_back(Demolish{city->city.buildings[*found]->sourceId});
        words += fmt::format("{}: {}\n", options.scenario, textOf((*scenario)->edits.back()));
    }
    return words;
}

}  // namespace

void addProjectAddScenario(CLI::App& project, Run& run) {
    const auto options = std::make_shared<AddOptions>();
    CLI::App* command = project.add_subcommand("add-scenario", "Add a scenario without edits");
    addProjectFile(*command, options->file);
    command->add_option("name", options->name, "Its name")->required()->type_name("NAME");
    command->add_option("--base", options->base, "The scenario that it starts from")
        ->default_val(existingCity)
        ->type_name("NAME");
    command->callback([options, &run] {
        run = [options](const Console& console) {
            return changeProject(options->file, console,
                                 [&](Project& changed) { return addScenario(*options, changed); });
        };
    });
}

void addProjectDemolish(CLI::App& project, Run& run) {
    const auto options = std::make_shared<DemolishOptions>();
    CLI::App* command = project.add_subcommand("demolish", "Demolish buildings in a scenario");
    addProjectFile(*command, options->file);
    command->add_option("buildings", options->buildings, "Their ids or names")
        ->required()
        ->type_name("BUILDING");
    command->add_option("--scenario", options->scenario, "The scenario to change")
        ->required()
        ->type_name("NAME");
    command->callback([options, &run] {
        run = [options](const Console& console) {
            return changeProject(options->file, console,
                                 [&](Project& changed) { return demolish(*options, changed); });
        };
    });
}

}  // namespace noonmark::cli
