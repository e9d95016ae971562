#pragma once

#include <functional>
#include <string>
#include <vector>

#include "app/cli/base/change_project.h"

namespace noonmark::cli {

/// Options shared by all commands that edit a scenario.
struct EditOptions {
    ChangeOptions change;
    std::string scenario;
};
void addScenarioOption(CLI::App& command, EditOptions& options);

/// Like addChangeCommand(), with the option of the scenario.
template <class Options>
CLI::App* addEditCommand(CLI::App& group, const char* name, const char* about,
                         const std::shared_ptr<Options>& options,
                         Result<std::string> (*change)(const Options&, Project&), Run& run) {
    CLI::App* command = addChangeCommand(group, name, about, options, change, run);
    addScenarioOption(*command, *options);
    return command;
}

/// Finds the scenario to change. Error: existingCity or an unknown name.
Result<Scenario*> scenarioToChange(Project& project, const std::string& name);

/// Error: an edit of the scenario, or of a scenario based on it, can no longer be applied.
Result<void> checkApplies(const Project& project, const std::string& scenario);

/// Appends edits to a scenario and returns their texts. Errors as of scenarioToChange() and checkApplies().
Result<std::string> withEdits(Project& project, const std::string& scenario, const std::vector<Edit>& edits);

/// Options of commands that treat several buildings alike.
struct BuildingsOptions : EditOptions {
    std::vector<std::string> buildings;  ///< ids or names
};
void addBuildings(CLI::App& command, BuildingsOptions& options);

/// A building in the scenario's city after the earlier edits.
struct FoundBuilding {
    const City& city;
    std::size_t index;
    [[nodiscard]] const Building& building() const { return *city.buildings[index]; }
};

/// An edit and an optional additional text to print. editBuildings() makes one for each building in turn and
/// prints it.
struct MadeEdit {
    Edit edit;
    std::string sayAlso;
};
Result<std::string> editBuildings(const BuildingsOptions& options, Project& project,
                                  const std::function<Result<MadeEdit>(const FoundBuilding&)>& make);

}  // namespace noonmark::cli
