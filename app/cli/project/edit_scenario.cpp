#include "app/cli/project/edit_scenario.h"

#include <fmt/format.h>

#include "core/describe/command_options.h"
#include "scenarios/edits/apply_edits.h"

namespace noonmark::cli {

namespace {

// Whether the scenario or one of its bases has this name. The project's scenarios are valid.
bool startsFrom(const Project& project, const Scenario* scenario, const std::string& name) {
    for (; scenario != nullptr; scenario = findScenario(project.scenarios, scenario->base))
        if (scenario->name == name) return true;
    return false;
}

Result<std::string> editOne(const BuildingsOptions& options, Project& project, const std::string& name,
                            const std::function<Result<MadeEdit>(const FoundBuilding&)>& make) {
    const auto city = cityOf(project, options.scenario);
    if (!city) return tl::make_unexpected(city.error());
    const auto found = findBuilding(city->city, name);
    if (!found) return tl::make_unexpected(found.error());
    const auto made = make({city->city, *found});
    if (!made) return tl::make_unexpected(made.error());
    return withEdits(project, options.scenario, {made->edit}).map([&](const std::string& words) {
        return made->sayAlso.empty() ? words : words + "  " + made->sayAlso + "\n";
    });
}

}  // namespace

void addScenarioOption(CLI::App& command, EditOptions& options) {
    command.add_option(flags::scenario, options.scenario, "The scenario to change")
        ->required()
        ->type_name("NAME");
}

void addBuildings(CLI::App& command, BuildingsOptions& options) {
    command.add_option("buildings", options.buildings, "Ids or names of the buildings")
        ->required()
        ->type_name("BUILDING");
}

Result<Scenario*> scenarioToChange(Project& project, const std::string& name) {
    if (name == existingCity)
        return failure("The existing city cannot be changed", "scenario 'Existing'",
                       "Add a scenario: noonmark-cli project add-scenario");
    if (project.scenarios.empty())
        return failure("The project has no scenario yet", "scenario '" + name + "'",
                       "Add it: noonmark-cli project add-scenario");
    if (const auto known = findScenarioByName(project, name); !known)
        return tl::make_unexpected(known.error());
    for (Scenario& scenario : project.scenarios)
        if (scenario.name == name) return &scenario;
    return nullptr;
}

Result<void> stillWorks(const Project& project, const std::string& scenario) {
    if (const auto own = cityOf(project, scenario); !own) return tl::make_unexpected(own.error());
    for (const Scenario& other : project.scenarios)
        if (startsFrom(project, &other, scenario))
            if (const auto city = cityOf(project, other.name); !city)
                return failure(city.error().what, city.error().where,
                               fmt::format("'{}' starts from '{}': change or remove its edit first",
                                           other.name, scenario));
    return {};
}

Result<std::string> withEdits(Project& project, const std::string& name, const std::vector<Edit>& edits) {
    const auto scenario = scenarioToChange(project, name);
    if (!scenario) return tl::make_unexpected(scenario.error());
    std::string words;
    for (const Edit& edit : edits) {
        (*scenario)->edits.push_back(edit);
        words += fmt::format("{}: {}\n", name, formatText(edit));
    }
    return stillWorks(project, name).map([&] { return words; });
}

Result<std::string> editBuildings(const BuildingsOptions& options, Project& project,
                                  const std::function<Result<MadeEdit>(const FoundBuilding&)>& make) {
    if (const auto known = scenarioToChange(project, options.scenario); !known)
        return tl::make_unexpected(known.error());
    std::string words;
    for (const std::string& building : options.buildings) {
        const auto line = editOne(options, project, building, make);
        if (!line) return line;
        words += *line;
    }
    return words;
}

}  // namespace noonmark::cli
