#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>
#include <ostream>

#include "app/cli/base/change_project.h"
#include "app/cli/base/command.h"
#include "app/cli/base/terminal_text.h"
#include "app/cli/project/project_commands.h"
#include "core/study/text/error_text.h"
#include "core/study/text/terrain_text.h"
#include "scenarios/project/project_file.h"

namespace noonmark::cli {

namespace {

using Json = nlohmann::ordered_json;

struct InfoOptions {
    std::string file;
    bool json = false;
};

template <class List, class NameOf>
Json namesOf(const List& list, NameOf nameOf) {
    Json names = Json::array();
    for (const auto& one : list) names.push_back(nameOf(one));
    return names;
}

constexpr auto ownName = [](const auto& one) { return one.name; };
constexpr auto sharedName = [](const auto& one) { return one->name; };

Json scenarioJson(const Scenario& scenario) {
    Json edits = Json::array();
    for (const Edit& edit : scenario.edits) edits.push_back(formatText(edit));
    return {{"name", scenario.name},
            {"base", scenario.base.empty() ? existingCity : scenario.base.c_str()},
            {"edits", edits}};
}

Json infoJson(const ProjectFile& disk) {
    const Project& project = disk.project();
    Json scenarios = Json::array();
    for (const Scenario& scenario : project.scenarios) scenarios.push_back(scenarioJson(scenario));
    return {{"file", disk.path().string()},
            {"saves", disk.saves()},
            {"buildings", project.city->buildings.size()},
            {"terrain", bool(project.city->terrain)},
            {"terrain_source", project.city->terrain ? terrainJson(*project.city->terrain) : Json()},
            {"attribution", project.attribution},
            {"warnings", warningsJson(project.reading->warnings)},
            {"regions", namesOf(project.regions, ownName)},
            {"places", namesOf(project.places, ownName)},
            {"lots", namesOf(project.lots, ownName)},
            {"scenarios", scenarios},
            {"weights", namesOf(project.weights, ownName)},
            {"periods", namesOf(project.periods, ownName)},
            {"views", namesOf(project.views, ownName)},
            {"results", namesOf(project.results, sharedName)},
            {"unsaved_work", bool(recoveryOf(disk.path()))}};
}

std::string joined(const Json& names) {
    std::string text;
    for (const Json& name : names) text += (text.empty() ? "" : ", ") + name.get<std::string>();
    return text.empty() ? "none" : text;
}

void print(const Json& info, std::ostream& out) {
    Table table;
    table.add("buildings", withCommas(info["buildings"].get<std::size_t>()));
    table.add("terrain", info["terrain"].get<bool>() ? info["terrain_source"]["text"].get<std::string>()
                                                     : "none: flat ground");
    table.add("places", withCommas(info["places"].size()));
    for (const char* key : {"regions", "lots", "weights", "periods", "views", "results"})
        table.add(key, joined(info[key]));
    if (info["unsaved_work"].get<bool>()) table.add("recovery", "there is a recovery file with unsaved work");
    table.print(out);
    for (const Json& scenario : info["scenarios"]) {
        out << fmt::format("\n{} (from {})\n", scenario["name"].get<std::string>(),
                           scenario["base"].get<std::string>());
        int number = 0;  // the number that `remove-edit` takes
        for (const Json& edit : scenario["edits"])
            out << fmt::format("{:4} {}\n", ++number, edit.get<std::string>());
    }
}

int runInfo(const InfoOptions& options, const Console& console) {
    const auto disk = ProjectFile::open(options.file);
    if (!disk) return fail(console, disk.error(), exitUsage);
    const Json info = infoJson(*disk);
    if (options.json)
        console.out << toJsonText(info) << '\n';
    else {
        print(info, console.out);
        printWarnings(console.out, disk->project().reading->warnings);
    }
    return exitOk;
}

}  // namespace

void addProjectInfo(CLI::App& project, Run& run) {
    const auto options = std::make_shared<InfoOptions>();
    CLI::App* command = project.add_subcommand("info", "Describe the contents of a project");
    addProjectFile(*command, options->file);
    addJsonFlag(*command, options->json);
    command->callback(
        [options, &run] { run = [options](const Console& console) { return runInfo(*options, console); }; });
}

}  // namespace noonmark::cli
