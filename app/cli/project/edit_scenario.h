#pragma once

#include <functional>
#include <string>
#include <vector>

#include "app/cli/project/change_project.h"

namespace noonmark::cli {

/// What all commands that edit a scenario share.
struct EditOptions {
    ChangeOptions change;
    std::string scenario;
};
void addScenarioOption(CLI::App& command, EditOptions& options);

/// As addChangeCommand, with the scenario.
template <class Options>
CLI::App* addEditCommand(CLI::App& group, const char* name, const char* about,
                         const std::shared_ptr<Options>& options,
                         Result<std::string> (*change)(const Options&, Project&), Run& run) {
    CLI::App* command = addChangeCommand(group, name, about, options, change, run);
    addScenarioOption(*command, *options);
    return command;
}

/// The scenario that a command changes; Error for existingCity or an unknown name.
Result<Scenario*> scenarioToChange(Project& project, const std::string& name);

/// Error: an edit of the scenario, or of one that starts from it, cannot be applied.
Result<void> stillWorks(const Project& project, const std::string& scenario);

/// Appends edits to a scenario and says them. Error as of scenarioToChange and stillWorks.
Result<std::string> withEdits(Project& project, const std::string& scenario, const std::vector<Edit>& edits);

/// Commands that do the same to each of several buildings.
struct BuildingsOptions : EditOptions {
    std::vector<std::string> buildings;  ///< ids or names
};
void addBuildings(CLI::App& command, BuildingsOptions& options);

/// A building of the scenario's city, where the edits before have left it.
struct FoundBuilding {
    const City& city;
    std::size_t index;
    [[nodiscard]] const Building& building() const { return *city.buildings[index]; }
};

/// Makes an edit of each building, one after the other, and says it; in the words of `sayAlso` too, where
/// that is not empty.
struct MadeEdit {
    Edit edit;
    std::string sayAlso;
};
Result<std::string> editBuildings(const BuildingsOptions& options, Project& project,
                                  const std::function<Result<MadeEdit>(const FoundBuilding&)>& make);

}  // namespace noonmark::cli
