#include <fmt/format.h>

#include <memory>
#include <ostream>

#include "app/cli/base/command.h"
#include "app/cli/project/list_project.h"
#include "app/cli/project/project_commands.h"
#include "core/base/safe_text.h"
#include "scenarios/project/project_file.h"
#include "scenarios/weights/time_weights.h"

namespace noonmark::cli {

namespace {

struct AddWeightsOptions {
    ChangeOptions change;
    std::string name;
    std::string table;
};

struct ShowOptions {
    std::string file;
    std::string name = "default";
    bool json = false;
};

Result<std::string> addWeights(const AddWeightsOptions& options, Project& project) {
    auto weights = readWeights(options.table, options.name);
    if (!weights) return tl::make_unexpected(weights.error());
    project.weights.push_back(*std::move(weights));
    return fmt::format("{}: {}\n", options.name,
                       countOf(project.weights.back().intervals.size(), "interval"));
}

std::vector<Listed> listWeights(const Project& project) {
    std::vector<Listed> lines;
    for (const TimeWeights& table : project.weights)
        lines.push_back({table.name,
                         countOf(table.intervals.size(), "interval"),
                         {{"intervals", table.intervals.size()}}});
    return lines;
}

Result<std::string> removeWeights(const RemoveOptions& options, Project& project) {
    return removeNamed(
        project.weights, options.names, [](const TimeWeights& table) { return table.name; },
        [&](const std::string& name) { return findWeights(project, name); });
}

int show(const ShowOptions& options, const Console& console) {
    const auto disk = ProjectFile::open(options.file);
    if (!disk) return fail(console, disk.error(), exitUsage);
    const auto weights = findWeights(disk->project(), options.name);
    if (!weights) return fail(console, weights.error(), exitUsage);
    console.out << (options.json ? weightsJson(*weights) + "\n" : weightsCsv(*weights));
    return exitOk;
}

void addShow(CLI::App& group, Run& run) {
    const auto options = std::make_shared<ShowOptions>();
    CLI::App* command = group.add_subcommand("show", "Print a table as the CSV or JSON that `add` reads");
    addProjectFile(*command, options->file);
    command->add_option("name", options->name, "Name of the table")->capture_default_str()->type_name("NAME");
    addJsonFlag(*command, options->json, "JSON instead of CSV");
    command->callback(
        [options, &run] { run = [options](const Console& console) { return show(*options, console); }; });
}

}  // namespace

void addProjectWeights(CLI::App& project, Run& run) {
    CLI::App* group =
        project.add_subcommand("weights", "Time weights: when shade is wanted and shadow is not");
    group->require_subcommand(1);
    const auto options = std::make_shared<AddWeightsOptions>();
    CLI::App* command = addChangeCommand(*group, "add", "Add a time-weight table", options, addWeights, run);
    command->add_option("name", options->name, "Name of the table")->required()->type_name("NAME");
    command
        ->add_option("table", options->table,
                     "CSV or JSON with one line per interval: name, first and last day (MM-DD), from and to "
                     "(HH:MM), weight (-1 to 1); `weights show` prints one to start from")
        ->required()
        ->type_name("FILE");
    addListCommand(*group, "List the tables", listWeights, run);
    addShow(*group, run);
    addRemoveCommand(*group, "Remove tables", removeWeights, run);
}

}  // namespace noonmark::cli
