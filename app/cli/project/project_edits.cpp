#include <memory>

#include "app/cli/options/shared_options.h"
#include "app/cli/project/edit_scenario.h"
#include "app/cli/project/project_commands.h"

namespace noonmark::cli {

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
