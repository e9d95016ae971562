#include "app/cli/project/edit_scenario.h"

#include <fmt/format.h>
#include <memory>

#include "app/cli/options/shared_options.h"
#include "app/cli/project/project_commands.h"
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

Result<void> checkApplies(const Project& project, const std::string& scenario) {
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
    return checkApplies(project, name).map([&] { return words; });
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

namespace {

struct HeightOptions : BuildingsOptions {
    double heightM = 0;
};

struct MoveOptions : BuildingsOptions {
    double eastM = 0;
    double northM = 0;
};

struct RotateOptions : BuildingsOptions {
    double clockwiseDeg = 0;
};

Result<std::string> demolish(const BuildingsOptions& options, Project& project) {
    return editBuildings(options, project, [](const FoundBuilding& found) -> Result<MadeEdit> {
        return MadeEdit{Demolish{found.building().sourceId}, {}};
    });
}

Result<std::string> changeHeight(const HeightOptions& options, Project& project) {
    return editBuildings(options, project, [&](const FoundBuilding& found) -> Result<MadeEdit> {
        return MadeEdit{ChangeHeight{found.building().sourceId, options.heightM}, {}};
    });
}

Result<std::string> move(const MoveOptions& options, Project& project) {
    if (options.eastM == 0 && options.northM == 0)
        return failure("The buildings would stay where they are", "move", "Give --east or --north");
    return editBuildings(options, project, [&](const FoundBuilding& found) -> Result<MadeEdit> {
        return MadeEdit{Move{found.building().sourceId, {options.eastM, options.northM}}, {}};
    });
}

Result<std::string> rotate(const RotateOptions& options, Project& project) {
    return editBuildings(options, project, [&](const FoundBuilding& found) -> Result<MadeEdit> {
        return MadeEdit{Rotate{found.building().sourceId, options.clockwiseDeg}, {}};
    });
}

void addDistance(CLI::App& command, const char* name, double& metres, const char* about) {
    command.add_option(name, metres, about)->check(within(-20000, 20000))->type_name("M");
}

}  // namespace

void addProjectDemolish(CLI::App& project, Run& run) {
    const auto options = std::make_shared<BuildingsOptions>();
    addBuildings(
        *addEditCommand(project, "demolish", "Demolish buildings in a scenario", options, demolish, run),
        *options);
}

void addProjectHeight(CLI::App& project, Run& run) {
    const auto options = std::make_shared<HeightOptions>();
    CLI::App* command = addEditCommand(project, "height", "Change the height of buildings in a scenario",
                                       options, changeHeight, run);
    addBuildings(*command, *options);
    command->add_option("--height", options->heightM, "Height above the ground, m")
        ->required()
        ->check(within(0.1, 2000))
        ->type_name("M");
}

void addProjectMove(CLI::App& project, Run& run) {
    const auto options = std::make_shared<MoveOptions>();
    CLI::App* command = addEditCommand(project, "move", "Move buildings of a scenario", options, move, run);
    addBuildings(*command, *options);
    addDistance(*command, "--east", options->eastM, "Distance to the east, m; negative: to the west");
    addDistance(*command, "--north", options->northM, "Distance to the north, m; negative: to the south");
}

void addProjectRotate(CLI::App& project, Run& run) {
    const auto options = std::make_shared<RotateOptions>();
    CLI::App* command = addEditCommand(
        project, "rotate", "Turn buildings of a scenario, each about its own centre", options, rotate, run);
    addBuildings(*command, *options);
    command->add_option("--clockwise", options->clockwiseDeg, "Degrees clockwise, seen from above")
        ->required()
        ->check(within(-360, 360))
        ->type_name("DEG");
}

}  // namespace noonmark::cli
