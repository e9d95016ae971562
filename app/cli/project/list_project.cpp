#include "app/cli/project/list_project.h"

#include <memory>
#include <ostream>

#include "app/cli/base/command.h"
#include "app/cli/base/terminal_text.h"
#include "core/study/text/error_text.h"
#include "scenarios/project/project_file.h"

namespace noonmark::cli {

namespace {

struct ListOptions {
    std::string file;
    bool json = false;
};

void printJson(const std::vector<Listed>& lines, std::ostream& out) {
    nlohmann::ordered_json all = nlohmann::ordered_json::array();
    for (const Listed& line : lines) {
        nlohmann::ordered_json one{{"name", line.name}};
        one.update(line.json);
        all.push_back(std::move(one));
    }
    out << toJsonText(all) << '\n';
}

int runList(const ListOptions& options, Lister lister, const Console& console) {
    const auto disk = ProjectFile::open(options.file);
    if (!disk) return fail(console, disk.error(), exitUsage);
    const std::vector<Listed> lines = lister(disk->project());
    if (options.json) {
        printJson(lines, console.out);
        return exitOk;
    }
    Table table;
    for (const Listed& line : lines) table.add(line.name, line.about);
    table.print(console.out);
    if (lines.empty()) console.out << "The project has none\n";
    return exitOk;
}

}  // namespace

void addListCommand(CLI::App& group, const char* about, Lister lister, Run& run) {
    const auto options = std::make_shared<ListOptions>();
    CLI::App* command = group.add_subcommand("list", about);
    addProjectFile(*command, options->file);
    addJsonFlag(*command, options->json);
    command->callback([options, lister, &run] {
        run = [options, lister](const Console& console) { return runList(*options, lister, console); };
    });
}

void addRemoveCommand(CLI::App& group, const char* about,
                      Result<std::string> (*remove)(const RemoveOptions&, Project&), Run& run) {
    const auto options = std::make_shared<RemoveOptions>();
    addChangeCommand(group, "remove", about, options, remove, run)
        ->add_option("names", options->names, "Names of the entries to remove")
        ->required()
        ->type_name("NAME");
}

}  // namespace noonmark::cli
